"""How a Cyclone DDS Domain block lets participants find each other: multicast, peers, interfaces."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.addresses import address_of
from bringup_lint.addresses import host_of
from bringup_lint.addresses import is_loopback
from bringup_lint.addresses import is_port
from bringup_lint.addresses import quad
from bringup_lint.addresses import split_port
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.cyclonedds import Setting
from bringup_lint.parsers.cyclonedds_values import size
from bringup_lint.source import Located
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.addresses import Address

PEER = "Discovery/Peers/Peer@Address"
INTERFACE = "General/Interfaces/NetworkInterface"


def multicast_off(domain: Domain) -> Setting | None:
    """The setting that forbids all multicast; None when some is allowed or nobody knows."""
    allowed = domain.get("General/AllowMulticast")
    if allowed is not None:
        return allowed if (allowed.effective or "").lower() == "false" else None
    interfaces = domain.found(INTERFACE)
    switches = [domain.of(each, "multicast") for each in interfaces]
    if switches and all(each is not None and (each.effective or "").lower() == "false" for each in switches):
        return switches[0]
    return None


def on_loopback_only(domain: Domain) -> bool:
    """Whether every interface of the block is the loopback one."""
    interfaces = domain.found(INTERFACE)
    names = [domain.of(each, "name") or domain.of(each, "address") for each in interfaces]
    old = domain.get("General/NetworkInterfaceAddress")
    names += [old] if old is not None else []
    return bool(names) and all(each is not None and is_loopback_interface(each.effective or "") for each in names)


def is_loopback_interface(text: str) -> bool:
    """Whether a setting names the loopback interface, by its name or its address."""
    return text == "lo" or is_loopback(text)


def finds_itself(domain: Domain, version: str) -> bool:
    """Whether the library adds the computer's own address where no peer is listed.

    Up to 0.10 it does for an interface that cannot do multicast, or may not by its own attribute (``q_init.c``,
    "If multicast was enabled but not available"); from 11 on wherever no interface may use multicast for discovery,
    unless AddLocalhost forbids it (``ddsi_init.c``, decide_participant_index_and_add_localhost_to_peers).
    """
    if version == "11":
        forbidden = domain.get("Discovery/Peers@AddLocalhost")
        return forbidden is None or (forbidden.effective or "").lower() != "false"
    switches = [domain.of(each, "multicast") for each in domain.found(INTERFACE)]
    if any(each is not None and (each.effective or "").lower() == "false" for each in switches):
        return True
    return on_loopback_only(domain)


def peers(domain: Domain) -> Iterator[Located]:
    """The addresses of all peers, one by one; those that depend on the environment are left out."""
    for setting in domain.all(PEER):
        if setting.effective is not None and setting.effective == setting.value:
            for part in _parts(setting.value):
                if part:
                    yield part


def has_peers(domain: Domain) -> bool:
    """Whether a peer is listed, or may be through a variable."""
    listed = (*domain.all(PEER), *domain.all("Discovery/Peers/Group/Peer@Address"))
    return any(setting.effective != "" for setting in listed)


def peer_addresses(domain: Domain) -> set[Address]:
    """The peers that are plain addresses."""
    return {address for address in map(address_of, peers(domain)) if address is not None}


def contacts_itself(domain: Domain) -> bool:
    """Whether a peer is this computer, or may be: host names and variables are not known."""
    listed = list(peers(domain))
    if len(domain.all(PEER)) != len([each for each in domain.all(PEER) if each.effective == each.value]):
        return True
    addresses = peer_addresses(domain)
    return len(addresses) < len({host_of(each) for each in listed}) or any(each.is_loopback for each in addresses)


def bad_addresses(setting: Setting) -> Iterator[tuple[Located, str]]:
    """The parts of a peer's address that are surely not an address, with the reason."""
    if setting.effective is None or setting.effective != setting.value:
        return
    for part in _parts(setting.value):
        host, port = split_port(part)
        if "/" in part:
            yield part, "is a network, not one host"
        elif max(quad(host) or (0,)) > 255:
            yield part, "has a number above 255"
        elif port is not None and not is_port(port):
            yield part, "has no port between 1 and 65535"


def _parts(value: Located) -> Iterator[Located]:
    start = 0
    for part in value.split(","):
        yield value.part(start, start + len(part))
        start += len(part) + 1


BUFFERS = (
    ("Internal/SocketReceiveBufferSize@min", "net.core.rmem_max"),
    ("Internal/MinimumSocketReceiveBufferSize", "net.core.rmem_max"),
    ("Internal/SocketSendBufferSize@min", "net.core.wmem_max"),
    ("Internal/MinimumSocketSendBufferSize", "net.core.wmem_max"),
)


def least_buffers(domain: Domain) -> Iterator[tuple[Setting, str]]:
    """The buffer sizes below which no participant is created, each with the kernel parameter that caps it."""
    for path, limit in BUFFERS:
        for setting in domain.all(path):
            yield setting, limit


def size_of(setting: Setting) -> int | None:
    """A memory size in bytes; None when it is the default or not known."""
    return None if setting.effective is None else size(setting.effective)


def domain_number(text: str) -> int | None:
    """The number of a Domain's Id; None for ``any``, a variable, or what is not a number."""
    return int(text) if text.isascii() and text.isdecimal() else None
