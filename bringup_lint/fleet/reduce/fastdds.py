"""What the default participant of Fast DDS says to other machines."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.fleet.reduce import said
from bringup_lint.fleet.reduce.said import Said
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.dds.machines import SERVER
from bringup_lint.graph.dds.machines import STATIC_PEERS
from bringup_lint.model.xml import Element
from bringup_lint.source import Located

PROFILES = ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE")
_OF_TRANSPORT = "FASTDDS_BUILTIN_TRANSPORTS"
_EASY = "ROS2_EASY_MODE"
_BUILTIN = {"DEFAULT": "UDPv4", "DEFAULTv6": "UDPv6", "UDPv4": "UDPv4", "UDPv6": "UDPv6", "SHM": "SHM"}
"""What each set of built-in transports takes to another machine; LARGE_DATA is several in turns."""
_TYPES = {"UDPv4": "UDPv4", "UDPv6": "UDPv6", "TCPv4": "TCPv4", "TCPv6": "TCPv6", "SHM": "SHM"}
_PORTS = (("portBase", 7400), ("domainIDGain", 250), ("offsetd0", 0))
_OWN_LOCATORS = ("initialPeersList", "metatrafficMulticastLocatorList", "metatrafficUnicastLocatorList")


def fastdds(participant: Element | None, transports: Sequence[Element], environment: Environment) -> Iterator[Said]:
    """What two robots must have in common. Without a profile, a participant has the defaults."""
    if environment.defines(_EASY) is not False:
        return
    rtps = participant.find("rtps") if participant is not None else None
    transport = _transport(rtps, transports, environment)
    if transport is not None:
        yield transport
    protocol = _protocol(rtps, environment)
    if protocol is None:
        return
    yield protocol
    if protocol.value == "SIMPLE" and environment.defines(STATIC_PEERS) is False and not _has_own_locators(rtps):
        yield Said(said.REACH, "multicast")
        yield from _port(rtps)


def _transport(rtps: Element | None, descriptors: Sequence[Element], environment: Environment) -> Said | None:
    builtin, own = _at(rtps, "builtinTransports"), _at(rtps, "userTransports")
    switch = _at(rtps, "useBuiltinTransports")
    written = switch or builtin or own
    chosen = environment.get(_OF_TRANSPORT)
    if chosen is not None:
        word = chosen.text or ""
        return Said(said.TRANSPORT, _BUILTIN[word], chosen.value) if written is None and word in _BUILTIN else None
    if environment.defines(_OF_TRANSPORT) is None:
        return None
    found: set[str | None] = set()
    if switch is None or switch.text not in ("false", "0"):
        found.add(_BUILTIN.get(_text(builtin, "DEFAULT")))
    if own is not None:
        found.update(_type_of(descriptors, name.text) for name in own.find_all("transport_id"))
    if not found or None in found:
        return None
    network = sorted(each for each in found if each is not None and each != "SHM")
    return Said(said.TRANSPORT, " ".join(network) or "SHM", written.text if written is not None else None)


def _type_of(descriptors: Sequence[Element], name: Located) -> str | None:
    """None for what is not defined here, or not known."""
    for each in descriptors:
        identifier, kind = each.find("transport_id"), each.find("type")
        if identifier is not None and kind is not None and identifier.text == name:
            return _TYPES.get(kind.text)
    return None


def _protocol(rtps: Element | None, environment: Environment) -> Said | None:
    """``SIMPLE``, or a discovery server, whatever the part in it: these two never find each other."""
    written = _at(rtps, "builtin", "discovery_config", "discoveryProtocol")
    servers = environment.get(SERVER)
    if written is not None and written.text != "SIMPLE":
        server = written.text in ("CLIENT", "SUPER_CLIENT", "SERVER", "BACKUP")
        return Said(said.PROTOCOL, "discovery server", written.text) if server else None
    if servers is not None and servers.text:
        return Said(said.PROTOCOL, "discovery server", servers.value)
    if environment.defines(SERVER) is None or (servers is not None and servers.text is None):
        return None
    return Said(said.PROTOCOL, "SIMPLE", written.text if written is not None else None)


def _has_own_locators(rtps: Element | None) -> bool:
    builtin = _at(rtps, "builtin")
    return builtin is not None and any(builtin.find(name) is not None for name in _OWN_LOCATORS)


def _port(rtps: Element | None) -> Iterator[Said]:
    written = {name: _at(rtps, "port", name) for name, _ in _PORTS}
    if any(each is not None and not each.text.isdecimal() for each in written.values()):
        return
    base, gain, offset = (int(_text(written[name], str(default))) for name, default in _PORTS)
    where = next((each.text for each in written.values() if each is not None), None)
    yield Said(said.PORT, said.port(base + offset, gain), where)


def _at(element: Element | None, *names: str) -> Element | None:
    """The element below another one, by the names on the way."""
    for name in names:
        element = element.find(name) if element is not None else None
    return element


def _text(element: Element | None, default: str) -> str:
    return default if element is None else str(element.text)
