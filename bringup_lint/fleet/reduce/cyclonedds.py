"""What the Domain blocks of Cyclone DDS say to other machines."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.addresses import is_loopback
from bringup_lint.fleet.reduce import said
from bringup_lint.fleet.reduce.said import Said
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.dds.cyclonedds_discovery import INTERFACE
from bringup_lint.graph.dds.cyclonedds_discovery import PEER
from bringup_lint.graph.dds.cyclonedds_discovery import has_peers
from bringup_lint.graph.dds.cyclonedds_discovery import multicast_off
from bringup_lint.graph.dds.cyclonedds_discovery import on_loopback_only
from bringup_lint.graph.dds.cyclonedds_discovery import peers
from bringup_lint.graph.dds.machines import STATIC_PEERS
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.parsers.cyclonedds_schema import schema
from bringup_lint.parsers.cyclonedds_values import size
from bringup_lint.source import Located

_TRANSPORTS = {"default": "UDPv4", "udp": "UDPv4", "udp6": "UDPv6", "tcp": "TCPv4", "tcp6": "TCPv6"}
_OLDER = ("General/UseIPv6", "TCP/Enable")
"""What decides on the transport where ``Transport`` does not."""
_PORTS = ("Base", "DomainGain", "MulticastMetaOffset")
_TUNING = (
    "Discovery/SPDPMulticastAddress",
    "General/FragmentSize",
    "General/MaxMessageSize",
    "Internal/SocketReceiveBufferSize@min",
    "Internal/SocketSendBufferSize@min",
    "Internal/Watermarks/WhcHigh",
    "Tracing/Verbosity",
)


def cyclonedds(domains: Sequence[Domain], environment: Environment) -> Iterator[Said]:
    """What two robots must have in common."""
    tag = _value(domains, "Discovery/Tag", "")
    if tag is not None:
        yield tag._replace(key=said.TAG, value=tag.value or "(none)")
    yield from _transport(domains)
    if environment.defines(STATIC_PEERS) is not False:
        return
    alone = _alone(domains)
    if alone is not None:
        yield alone
    elif not any(map(has_peers, domains)) and all(map(_discovers_by_multicast, domains)):
        yield Said(said.REACH, "multicast")
        yield from _port(domains)


def _transport(domains: Sequence[Domain]) -> Iterator[Said]:
    found = _value(domains, "General/Transport", "default")
    if found is None or found.value not in _TRANSPORTS:
        return
    if found.value == "default" and any(domain.get(path) for domain in domains for path in _OLDER):
        return
    yield Said(said.TRANSPORT, _TRANSPORTS[found.value], found.where)


def _alone(domains: Sequence[Domain]) -> Said | None:
    """Why a robot keeps to itself: it uses the loopback interface alone, or neither multicast nor a peer elsewhere."""
    if len(domains) != 1:
        return None
    domain = domains[0]
    if on_loopback_only(domain):
        return Said(said.REACH, "the loopback interface alone", _first_interface(domain))
    off = multicast_off(domain)
    if off is None or domain.all("Discovery/Peers/Group/Peer@Address"):
        return None
    known = all(each.effective == each.value for each in domain.all(PEER))
    here = known and all(each == "localhost" or is_loopback(each) for each in peers(domain))
    return Said(said.REACH, "neither multicast nor another machine", off.value) if here else None


def _first_interface(domain: Domain) -> Located | None:
    elements = domain.found(INTERFACE) or domain.found("General/NetworkInterfaceAddress")
    return elements[0].name if elements else None


def _discovers_by_multicast(domain: Domain) -> bool:
    allowed = domain.get("General/AllowMulticast")
    by_interface = ("multicast", "allow_multicast")
    if any(domain.of(each, name) for each in domain.found(INTERFACE) for name in by_interface):
        return False
    return allowed is None or (allowed.effective or "").lower() in ("true", "default", "spdp")


def _port(domains: Sequence[Domain]) -> Iterator[Said]:
    """Where the multicast of discovery arrives. Peers may have a port of their own: this says nothing of them."""
    if any(domain.get("Discovery/ExternalDomainId") for domain in domains):
        return
    found = [_value(domains, f"Discovery/Ports/{name}", default) for name, default in zip(_PORTS, ("7400", "250", "0"))]
    known = [each for each in found if each is not None and each.value.isdecimal()]
    if len(known) == len(_PORTS):
        base, gain, offset = (int(each.value) for each in known)
        where = next((each.where for each in known if each.where is not None), None)
        yield Said(said.PORT, said.port(base + offset, gain), where)


def tuning(domains: Sequence[Domain], version: str) -> Iterator[Said]:
    """What robots of one role have alike, and what does not surely keep them from each other."""
    for path in _TUNING:
        item = schema(version).items.get(f"CycloneDDS/Domain/{path}")
        default = item.row.get("default", "") if item is not None else ""
        found = _value(domains, path, default)
        if item is None or found is None:
            continue
        number = size(found.value)
        yield found._replace(key=f"CycloneDDS {path}", value=found.value if number is None else f"{number} B")


def _value(domains: Sequence[Domain], path: str, default: str) -> Said | None:
    """What all blocks together say of a setting; None where that is not known, or they contradict each other."""
    written = [setting for domain in domains for setting in domain.all(path)]
    values = {setting.effective for setting in written}
    if not values:
        return Said(path, default)
    value = values.pop()
    return None if values or value is None else Said(path, value, written[-1].value)
