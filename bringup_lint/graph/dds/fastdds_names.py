"""What a remark about a Fast DDS file could mean, and where they are."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from bringup_lint.addresses import address_of
from bringup_lint.addresses import parse_address
from bringup_lint.model.fastdds import VERSIONS
from bringup_lint.model.fastdds import Profile
from bringup_lint.model.fastdds import Profiles
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.model.xml import Element
from bringup_lint.parsers.fastdds import locators
from bringup_lint.parsers.fastdds_schema import elsewhere
from bringup_lint.parsers.fastdds_schema import schema
from bringup_lint.parsers.names_beside import attributes_beside
from bringup_lint.parsers.names_beside import elements_beside
from bringup_lint.parsers.names_beside import is_free
from bringup_lint.pattern import regex
from bringup_lint.schema.names import find
from bringup_lint.schema.names import suggestions
from bringup_lint.source import Located
from bringup_lint.source import Span
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.addresses import Address

LOCATOR_LISTS = regex(r"LocatorList$|^initialPeersList$|external_unicast_locators$")


def shape(path: str, version: str) -> Item | None:
    """The item that lists what may appear inside a path."""
    known = schema(version)
    item = known.items.get(path)
    return None if item is None else known.inside(item)


def meant_name(profiles: Profiles, remark: Remark) -> str | None:
    """The one name of the same place that a misspelt one means."""
    item = shape(remark.path, profiles.version)
    known = {} if item is None else item.children if remark.code == Code.UNKNOWN else item.attributes
    found = suggestions(known, remark.detail)
    return found[0] if len(found) == 1 else None


def is_beside(profiles: Profiles, unknown: Located, name: str) -> bool:
    """Whether an element or attribute of a name is beside the one whose name is unknown."""
    return name in _names_beside(profiles, unknown)


def can_be_renamed(profiles: Profiles, remark: Remark, name: str) -> bool:
    """Whether an unknown element or attribute that gets a name is the only one of that name."""
    item = shape(remark.path, profiles.version)
    known = {*item.children, *item.attributes} if item else ()
    return is_free(name, remark.word.rpartition(":")[2], _names_beside(profiles, remark.word), known)


def _names_beside(profiles: Profiles, unknown: Located) -> Counter[str]:
    return elements_beside(profiles.document, unknown) or attributes_beside(unknown)


def versions_with(remark: Remark) -> list[str]:
    """The other versions that take the name at this place."""
    found = []
    for version in VERSIONS:
        item = shape(remark.path, version)
        known = {} if item is None else item.children if remark.code == Code.UNKNOWN else item.attributes
        if find(known, remark.detail).item is not None:
            found.append(version)
    return found


def place_of(profiles: Profiles, remark: Remark) -> str:
    """Where an element of this name may appear, such as ``rtps``; empty when nowhere or in several places."""
    found = {path.rpartition("/")[0] for path in elsewhere(remark.detail, profiles.version)}
    near = [path for path in found if path.startswith(remark.path) or remark.path.startswith(path)]
    return near[0].rpartition("/")[2] if len(near) == 1 else ""


def words_taken(profiles: Profiles, remark: Remark) -> tuple[str, ...]:
    """The words that the element of a remark takes."""
    item = schema(profiles.version).items.get(remark.path)
    return item.words if item else ()


def first_named(profiles: Profiles, remark: Remark) -> Located | None:
    """The first profile or transport of the same name."""
    if remark.code == Code.TRANSPORT_DUPLICATE:
        return transport_named(profiles, str(remark.where))
    kind = remark.path.rpartition("/")[2]
    return next((each.name for each in profiles.of_kind(kind) if each.name == remark.where), None)


def transport_named(profiles: Profiles, name: str) -> Located | None:
    """Where a transport is defined."""
    for descriptor in profiles.transports:
        identifier = descriptor.find("transport_id")
        if identifier is not None and identifier.text == name:
            return identifier.text
    return None


def with_blanks(text: Located) -> Span:
    """The span of an element's text with the blanks around it."""
    source, start, end = text.span
    while start and source.text[start - 1] in " \t\r\n":
        start -= 1
    while end < len(source.text) and source.text[end] in " \t\r\n":
        end += 1
    return Span(source, start, end)


def locator_ports(profiles: Profiles) -> Iterator[Located]:
    """The text of every port of a UDP locator."""
    for element in profiles.document.elements:
        if LOCATOR_LISTS.search(element.name):
            for transport in locators(element):
                port = transport.find("port")
                if port is not None and transport.name.startswith("udp"):
                    yield port.text


def multicast_peers(peers: Element) -> bool:
    """Whether a list of peers names a multicast group itself."""
    addresses = (child.find("address") for child in locators(peers))
    found = (parse_address(each.text) for each in addresses if each is not None)
    return any(each is not None and each.is_multicast for each in found)


def initial_peers(profiles: Profiles) -> Iterator[Element]:
    """The address of every initial peer."""
    for element in profiles.document.elements:
        if element.name == "initialPeersList":
            addresses = (child.find("address") for child in locators(element))
            yield from (each for each in addresses if each is not None)


def whitelisted_addresses(element: Element) -> list[tuple[Located, Address]]:
    """The addresses of an ``interfaceWhiteList`` element; empty for others, and for one that lists names too."""
    if element.name != "interfaceWhiteList":
        return []
    found = [(child.text, address_of(child.text)) for child in element.children if child.name == "address"]
    others = len(element.children) > len(found) or any(address is None for _, address in found)
    return [] if others else [(text, address) for text, address in found if address is not None]


def seconds(element: Element | None, default: float) -> float | None:
    """A duration; None when it is infinite or depends on a variable."""
    if element is None:
        return default
    parts = {str(child.name): str(child.text) for child in element.children}
    if not parts or not all(text.isdecimal() for text in parts.values()):
        return None
    return int(parts.get("sec", "0")[:18]) + int(parts.get("nanosec", "0")[:18]) / 1e9


def number(element: Element | None, default: int) -> int | None:
    """A plain number; None when it is something else."""
    if element is None:
        return default
    return int(element.text) if element.text.isdecimal() else None


def used_transports(profiles: Profiles) -> set[str]:
    """The transports that the default participants name."""
    participants = [profile.element for profile in profiles.of_kind("participant") if profile.is_default]
    return {
        str(name.text)
        for participant in participants
        for element in participant.walk()
        if element.name == "userTransports"
        for name in element.find_all("transport_id")
    }


def transport_type(name: Located) -> str:
    """The type of the transport that an element, given by its name, is in."""
    before = name.span.source.text[: name.span.start]
    inside = before[before.rfind("<transport_descriptor>") :] + name.span.source.text[name.span.start :]
    match = re.search(r"<type>\s*(\w+)", inside)
    return match[1] if match else ""


OVERWRITTEN = {"reliability", "durability", "historyQos", "publishMode"}
"""What rmw_fastrtps sets itself unless RMW_FASTRTPS_USE_QOS_FROM_XML is 1."""


def overwritten_qos(profile: Profile) -> list[Element]:
    """The QoS elements of an endpoint profile that the RMW overwrites."""
    return [element for element in profile.element.walk() if element.name in OVERWRITTEN and element.children]
