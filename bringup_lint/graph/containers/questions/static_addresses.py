"""Fixed addresses of services, and the subnets of their networks."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.addresses import PREFIX_LENGTH
from bringup_lint.addresses import parse_address
from bringup_lint.addresses import parse_network
from bringup_lint.graph.containers.questions.compose_projects import Projects
from bringup_lint.model.compose import ComposeFile
from bringup_lint.model.compose import Service
from bringup_lint.model.compose import is_variable
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.addresses import Address
    from bringup_lint.addresses import Network
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.source import Located

_KEYS = ("ipv4_address", "ipv6_address")


class RefusedAddress(NamedTuple):
    """A fixed address with which docker does not start the container of a service."""

    why: str
    """``outside`` (of each subnet), ``gateway``, ``taken`` or ``no subnet``."""
    service: Service
    address: Located
    network: str
    other: Located
    """The subnet, the gateway, the same address of another service, or the name of the network."""


def refused_addresses(compose: Compose) -> Iterator[RefusedAddress]:
    """What docker refuses, as far as one file says it, or one that includes it."""
    projects = Projects(compose)
    for file in compose.files:
        if file.source.judged and not file.source.template and file.yaml.complete:
            yield from _of(compose, file, projects)


class _Network(NamedTuple):
    """What ``ipam:`` gives to a network."""

    name: Located
    bare: bool
    """It has no subnet, and no other file of the folder speaks of it."""
    subnet: Located | None
    """The first of those that are all known."""
    prefixes: set[tuple[int, int, int]]
    lengths: set[tuple[int, int]]
    """Family and length of these."""
    gateways: dict[str, Located]


def _of(compose: Compose, file: ComposeFile, projects: Projects) -> Iterator[RefusedAddress]:
    owners: dict[tuple[str, str], tuple[Service, Located]] = {}
    networks: dict[str, _Network | None] = {}
    for service in file.services:
        for name, address in _given(service):
            parsed = parse_address(address)
            if parsed is None:
                continue
            if name not in networks:
                defined = _definition(file, name, projects)
                networks[name] = _network(compose, defined[0], *defined[1]) if defined is not None else None
            network = networks[name]
            if network is None:
                continue
            yield from _refused(network, service, address, parsed)
            first = owners.setdefault((name, str(address)), (service, address))
            if first[0] is not service and not first[0].profiles and not service.profiles:
                yield RefusedAddress("taken", service, address, name, first[1])


def _definition(
    file: ComposeFile, network: str, projects: Projects
) -> tuple[ComposeFile, tuple[Scalar, object]] | None:
    """The entry of a network in the file, or in the one file of its project that has it."""
    own = _entry(file, network)
    if own is not None:
        return file, own
    others = [(each, _entry(each, network)) for each in projects.of(file) or ()]
    found = [(each, entry) for each, entry in others if entry is not None]
    return found[0] if len(found) == 1 else None


def _entry(file: ComposeFile, network: str) -> tuple[Scalar, object] | None:
    root = file.yaml.root
    networks = root.mapping("networks") if isinstance(root, Mapping) else None
    return networks.entry(network) if networks is not None else None


def _given(service: Service) -> Iterator[tuple[str, Located]]:
    """The networks of a service in which it has a fixed address, with that address."""
    networks = service.get("networks")
    if not isinstance(networks, Mapping):
        return
    for name, body in networks.merged:
        if isinstance(body, Mapping):
            found = (body.scalar(key) for key in _KEYS)
            yield from ((str(name.value), address.value) for address in found if address is not None)


def _refused(network: _Network, service: Service, address: Located, parsed: Address) -> Iterator[RefusedAddress]:
    name = str(network.name)
    if network.bare:
        yield RefusedAddress("no subnet", service, address, name, network.name)
    own = (_prefix(parsed, length) for family, length in network.lengths if family == parsed.version)
    if network.subnet is not None and network.prefixes.isdisjoint(own):
        yield RefusedAddress("outside", service, address, name, network.subnet)
    if address in network.gateways:
        yield RefusedAddress("gateway", service, address, name, network.gateways[address])


def _network(compose: Compose, file: ComposeFile, name: Scalar, body: object) -> _Network:
    is_external = isinstance(body, Mapping) and body.get("external") is not None
    configs = None if is_external else _configs(body)
    subnets = {text: parsed for each in configs or () for text, parsed in _subnet(each)}
    parsed = [each for each in subnets.values() if each is not None]
    gateways = [each.scalar("gateway") for each in configs or ()] if subnets else []
    return _Network(
        name.value,
        configs == [] and not _is_defined_elsewhere(compose, file, str(name.value)),
        next(iter(subnets), None) if len(parsed) == len(subnets) else None,
        {_prefix(each.network_address, each.prefixlen) for each in parsed},
        {(each.version, each.prefixlen) for each in parsed},
        {str(each.value): each.value for each in gateways if each is not None},
    )


def _prefix(address: Address, length: int) -> tuple[int, int, int]:
    return address.version, length, int(address) >> PREFIX_LENGTH[address.version] - length


def _configs(body: object) -> list[Mapping] | None:
    """The entries of ``ipam: config:``; None where something else than these may give the addresses."""
    if not isinstance(body, Mapping):
        return []
    ipam = body.get("ipam")
    if ipam is None:
        driver = body.scalar("driver")
        return [] if driver is None or driver.value == "bridge" else None
    if not isinstance(ipam, Mapping):
        return None
    driver = ipam.scalar("driver")
    if ipam.get("driver") is not None and (driver is None or driver.value != "default"):
        return None
    config = ipam.sequence("config")
    return [each for each in config if isinstance(each, Mapping)] if config is not None else None


def _subnet(config: Mapping) -> Iterator[tuple[Located, Network | None]]:
    """The subnet of an entry; None for one that a variable gives."""
    subnet = config.scalar("subnet")
    if subnet is not None:
        yield subnet.value, None if is_variable(subnet.value) else parse_network(subnet.value)


def _is_defined_elsewhere(compose: Compose, file: ComposeFile, network: str) -> bool:
    """Whether another file of the folder speaks of the network, so that both may be put together."""
    for other in compose.by_folder[os.path.dirname(file.source.name)]:
        root = other.yaml.root
        networks = root.mapping("networks") if isinstance(root, Mapping) and other is not file else None
        if networks is not None and networks.entry(network) is not None:
            return True
    return False
