"""The elements that a version of Fast DDS knows."""

from __future__ import annotations

from dataclasses import dataclass
from dataclasses import field
from functools import lru_cache

from bringup_lint.facts import table
from bringup_lint.model.fastdds import VERSIONS


@dataclass(frozen=True, eq=False, slots=True)
class Item:
    path: str
    name: str
    check: str
    """How the text is read: ``group``, a structure in braces, ``bool``, ``number``, ``enum``, ``text``, ...
    """
    allowed: tuple[str, ...]
    required: bool
    passes_over: bool
    """Unknown children are passed over, not refused."""
    not_empty: bool
    once: bool
    aliases: tuple[str, ...]
    only: tuple[str, ...]
    """The kinds of transport (udp, tcp, shm) that read the element; empty for all."""
    ignored: bool
    """The library says that it does not support it, and goes on."""
    children: dict[str, Item] = field(default_factory=dict)
    attributes: dict[str, Item] = field(default_factory=dict)


@lru_cache
def schema(version: str) -> dict[str, Item]:
    """Path -> item; a structure that several places share stands under its name in braces."""
    items: dict[str, Item] = {}
    for row in table("dds/fastdds"):
        if row[version] != "no":
            items[row["path"]] = _item(row, row[version])
    roots = {path.partition("/")[0].partition("@")[0] for path in items if path.startswith("{")}
    for root in roots:
        items[root] = Item(root, root, "group", (), False, False, False, False, (), (), False)
    for path, item in items.items():
        parent = path.rpartition("@" if "@" in path else "/")[0]
        if parent in items:
            siblings = items[parent].attributes if "@" in path else items[parent].children
            for name in (item.name, *item.aliases):
                siblings[name] = item
    return items


def _item(row: dict[str, str], status: str) -> Item:
    return Item(
        row["path"],
        row["path"].replace("@", "/").rpartition("/")[2],
        row["check"],
        tuple(row["allowed"].split("|")) if row["allowed"] else (),
        row["required"] == "yes",
        row["unknown"] == "ignored",
        row["empty"] == "error",
        row["twice"] == "error",
        tuple(row["aliases"].split(",")) if row["aliases"] else (),
        tuple(row["only"].split(",")) if row["only"] else (),
        status == "ignored",
    )


@lru_cache
def versions_with(path: str) -> tuple[str, ...]:
    """The versions that take a path."""
    return tuple(version for version in VERSIONS if path in schema(version))


@lru_cache
def elsewhere(name: str, version: str) -> tuple[str, ...]:
    """The paths at which an element of this name may stand."""
    return tuple(path for path, item in schema(version).items() if item.name == name and "@" not in path)
