"""What a name or value that Cyclone DDS does not know could mean: another version, another place, another
spelling."""

from __future__ import annotations

import re
from collections import Counter

from bringup_lint.finding import Edit
from bringup_lint.finding import Fix
from bringup_lint.model.cyclonedds import VERSIONS
from bringup_lint.model.cyclonedds import Configuration
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.parsers.cyclonedds_schema import repeats
from bringup_lint.parsers.cyclonedds_schema import schema
from bringup_lint.parsers.cyclonedds_values import THREADS
from bringup_lint.parsers.cyclonedds_values import fault_of
from bringup_lint.parsers.cyclonedds_values import words
from bringup_lint.parsers.names_beside import MOST_NAMES
from bringup_lint.parsers.names_beside import attributes_beside
from bringup_lint.parsers.names_beside import elements_beside
from bringup_lint.parsers.names_beside import is_free
from bringup_lint.source import Located
from bringup_lint.spelling import nearest


def versions_with(remark: Remark) -> list[str]:
    """The other versions that take what this version refuses."""
    if remark.item is None:
        return []
    if remark.code in (Code.VALUE, Code.RANGE):
        return [version for version in VERSIONS if _takes(version, remark.item, str(remark.where))]
    mark = "@" if remark.code == Code.UNKNOWN_ATTRIBUTE else "/"
    path = f"{remark.item.path}{mark}{remark.detail}".lower()
    return [version for version in VERSIONS if path in {known.lower() for known in schema(version).items}]


def _takes(version: str, item: Item, text: str) -> bool:
    other = schema(version).items.get(item.path)
    return other is not None and not other.moved_to and fault_of(other, text, version) is None


def meant_item(remark: Remark) -> Item | None:
    """The one item of the same place that a misspelt name means."""
    if remark.item is None:
        return None
    items = remark.item.attributes if remark.code == Code.UNKNOWN_ATTRIBUTE else remark.item.children
    if remark.item.path == "CycloneDDS":
        items = {name: item for name, item in items.items() if not item.moved_to}
    found = nearest(remark.detail, items)
    return items[found[0]] if len(found) == 1 else None


def can_be_renamed(configuration: Configuration, name: Located, meant: Item) -> bool:
    """Whether what a name means is given once when it has the right name, or may be given several times."""
    if repeats(meant):
        return True
    names = attributes_beside(name) if meant.is_attribute else elements_beside(configuration.document, name)
    if len(names) > MOST_NAMES:
        return False
    lowered: Counter[str] = Counter()
    for each, number in names.items():
        lowered[each.lower()] += number
    parent = schema(configuration.version).items.get(meant.path.rpartition("@" if meant.is_attribute else "/")[0])
    known = {each.lower() for each in (parent.attributes if meant.is_attribute else parent.children)} if parent else ()
    words = {meant.name.lower(), *(each.lower() for each in meant.aliases)} - {name.lower()}
    return all(is_free(each, name.lower(), lowered, known) for each in words)


def place_of(configuration: Configuration, remark: Remark) -> str:
    """Where an item of this name may appear, such as ``General``; empty when nowhere or in several places."""
    known = [item for item in schema(configuration.version).named(remark.detail) if not item.moved_to]
    wanted = [item for item in known if item.is_attribute == (remark.code == Code.UNKNOWN_ATTRIBUTE)]
    if len(wanted) != 1:
        return ""
    parent = wanted[0].path.rpartition("@" if wanted[0].is_attribute else "/")[0]
    return parent.removeprefix("CycloneDDS/Domain/").removeprefix("CycloneDDS/")


def first_named(configuration: Configuration, remark: Remark) -> Located | None:
    """The first name of a setting that is given twice."""
    domain = configuration.domain_of(remark)
    first = domain.first(remark.path) if domain and remark.item else None
    return first.name if first else None


def has_address(configuration: Configuration, remark: Remark) -> bool:
    """Whether a NetworkInterfaceAddress holds an address, and no name of an interface."""
    domain = configuration.domain_of(remark)
    item = domain.get("General/NetworkInterfaceAddress") if domain else None
    return item is not None and item.name is remark.where and str(item.value)[:1].isdigit()


def interfaces_instead(configuration: Configuration, remark: Remark) -> Fix | None:
    """Replace NetworkInterfaceAddress by an Interfaces group; only for one plain interface name."""
    domain = configuration.domain_of(remark)
    old = domain.get("General/NetworkInterfaceAddress") if domain else None
    if domain is None or old is None or old.name is not remark.where or domain.found("General/Interfaces"):
        return None
    value = str(old.value)
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_.-]*", value) or value.lower() == "auto":
        return None
    new = f'<Interfaces><NetworkInterface name="{value}"/></Interfaces>'
    return Fix("write an Interfaces group", (Edit(old.owner.span, new),))


def taken_by(item: Item) -> str:
    """What an item takes, as advice."""
    known = words(item)
    if item.type == "list":
        return f"write a comma list without blanks of {', '.join(known)}" if len(known) > 1 else "write a comma list"
    limits = re.search(r"(-?[0-9]+)\.\.(-?[0-9]+)", item.allowed)
    choices = [*known, f"a number from {limits[1]} to {limits[2]}"] if limits and item.type == "int" else known
    if item.name == "Name":
        choices = list(THREADS)
    if not choices:
        return "write a number with a unit"
    *others, last = choices
    return f"write {', '.join(others)} or {last}" if others else f"write {last}"
