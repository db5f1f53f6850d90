"""The names that a version of Cyclone DDS knows, and the library's way of matching them.

Names ignore case. An alias counts like the name. Only XML given inline in ``CYCLONEDDS_URI`` may shorten a
name to a unique
prefix (``find_cfgelem_by_name`` in ddsi_config.c).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

from bringup_lint.facts import table
from bringup_lint.model.cyclonedds import VERSIONS
from bringup_lint.model.cyclonedds import Item


class Match(NamedTuple):
    item: Item | None
    how: str
    """exact, alias, prefix, ambiguous or unknown."""


@dataclass(frozen=True)
class Schema:
    """Everything one version knows, as a tree."""

    version: str
    root: Item
    by_path: dict[str, Item]

    def elsewhere(self, name: str) -> list[Item]:
        """The items that carry this name anywhere, for suggestions."""
        wanted = name.lower()
        return [item for item in self.by_path.values() if item.name.lower() == wanted and not item.moved_to]


@lru_cache
def schema(version: str) -> Schema:
    items: dict[str, Item] = {}
    for row in table("dds/cyclonedds"):
        status = row[version]
        if status != "no":
            items[row["path"]] = _item(row, status, version)
    for path, item in items.items():
        parent, _, _ = path.rpartition("@" if "@" in path else "/")
        if parent:
            (items[parent].attributes if "@" in path else items[parent].children).append(item)
    return Schema(version, items["CycloneDDS"], items)


@lru_cache
def versions_with(path: str) -> tuple[str, ...]:
    """The versions that accept a path."""
    for row in table("dds/cyclonedds"):
        if row["path"] == path:
            return tuple(version for version in VERSIONS if row[version] != "no")
    return ()


def _item(row: dict[str, str], status: str, version: str) -> Item:
    path = row["path"]
    return Item(
        path,
        path.replace("@", "/").rpartition("/")[2],
        row["type"],
        _for_version(row["allowed"], version),
        row["bare"],
        _for_version(row["default"], version),
        row["max"] == "unbounded",
        row["required"] == "yes",
        tuple(row["aliases"].split(",")) if row["aliases"] else (),
        status == "deprecated",
        status.removeprefix("moved:") if status.startswith("moved:") else "",
        frozenset(_features(row["build"], version)),
    )


def _for_version(cell: str, version: str) -> str:
    """The part of a cell ``A ; 0.7,0.8: B`` that counts for a version."""
    newest, *older = cell.split(" ; ")
    for part in older:
        versions, _, value = part.partition(": ")
        if version in versions.split(","):
            return value
    return newest.strip()


def _features(cell: str, version: str) -> list[str]:
    import re

    found = re.findall(r"(\w+)(?:\(([^)]*)\))?", cell)
    return [name for name, versions in found if not versions or version in versions.split(",")]


def _begins(item: Item, wanted: str) -> bool:
    """Whether a name is the beginning of an item's. By a slip of the library, the name of an item with aliases may also
    be the beginning of what is written."""
    if item.deprecated:
        return False
    name = item.name.lower()
    return name.startswith(wanted) or (bool(item.aliases) and wanted.startswith(name))


def match(items: list[Item], name: str, inline: bool) -> Match:
    """Find the item that a written name means."""
    wanted = name.lower()
    for item in items:
        if item.name.lower() == wanted:
            return Match(item, "exact")
        if any(alias.lower() == wanted for alias in item.aliases):
            return Match(item, "alias")
    prefixed = [item for item in items if _begins(item, wanted)]
    if not prefixed:
        return Match(None, "unknown")
    if len(prefixed) > 1:
        return Match(None, "ambiguous" if inline else "unknown")
    return Match(prefixed[0], "prefix")
