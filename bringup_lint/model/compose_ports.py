"""The ports that a compose service publishes: the short and the long syntax of ``ports:``."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.compose import Service
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_SHORT = regex(
    r"(?:(?P<address>[\d.]{7,15}|\[[\da-fA-F:]{2,39}\]|localhost):)?(?:(?P<host>\d{1,5}(?:-\d{1,5})?)?:)?"
    r"(?P<inside>\d{1,5}(?:-\d{1,5})?)(?:/(?P<protocol>tcp|udp|sctp))?"
)
_RANGE = regex(r"(?P<first>\d{1,5})(?:-(?P<last>\d{1,5}))?")


class Published(NamedTuple):
    """One entry of ``ports:``."""

    where: Located
    address: str
    """Of the host; empty for all of them."""
    host: range
    """Empty where Docker chooses the port."""
    inside: range
    """The ports of the container."""
    protocol: str


def published(service: Service) -> Iterator[Published]:
    """What a service publishes, with what it extends; entries with variables, which may be any port, are left out."""
    if service.base is not None:
        yield from published(service.base)
    node = service.body.get("ports")
    if not isinstance(node, Sequence):
        return
    for item in node.items:
        found = None
        if isinstance(item, Scalar):
            found = _short(item.value)
        elif isinstance(item, Mapping):
            found = _long(item)
        if found is not None:
            yield found


def _short(text: Located) -> Published | None:
    match = _SHORT.fullmatch(text)
    if match is None:
        return None
    host, inside = _range(match["host"]), _range(match["inside"])
    return Published(text, match["address"] or "", _fixed(host, inside), inside, match["protocol"] or "tcp")


def _long(item: Mapping) -> Published | None:
    words = {key: item.scalar(key) for key in ("target", "published", "protocol", "host_ip")}
    target, host, protocol, address = words.values()
    if target is None or not _RANGE.fullmatch(target.value):
        return None
    if host is not None and not _RANGE.fullmatch(host.value):
        return None
    inside = _range(target.value)
    return Published(
        (host or target).value,
        str(address.value) if address else "",
        _fixed(_range(host.value if host else None), inside),
        inside,
        str(protocol.value) if protocol else "tcp",
    )


def _fixed(host: range, inside: range) -> range:
    """The ports of the host; of a range for one port, Docker takes one that is free."""
    return host if len(host) == len(inside) else range(0)


def _range(text: str | None) -> range:
    match = _RANGE.fullmatch(text or "")
    return range(int(match["first"]), int(match["last"] or match["first"]) + 1) if match else range(0)
