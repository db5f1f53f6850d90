"""A table of facts as a tree of items.

Columns that every table may have: ``path``, ``type``, ``allowed``, ``required`` (yes), ``max`` (1), ``aliases``
(comma-separated), ``order``, ``since``, and one column for each version with ``yes``, ``no``, ``deprecated``,
``ignored`` or ``moved:PATH``. Other columns belong to the format alone: ``Item.row``.
"""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from collections.abc import Sequence

from bringup_lint.dataclass import dataclass
from bringup_lint.facts import table
from bringup_lint.model.schema import Item


@dataclass(frozen=True, eq=False)
class Schema:
    """Everything that one version of a program knows of its format."""

    items: dict[str, Item]
    """Path to item, in the order of the table."""
    top: Item
    """Holds what has no parent: the root element, sections or keywords."""

    def inside(self, item: Item) -> Item:
        """The item that lists what may appear inside another: itself, or the structure that it names."""
        return self.items.get(item.type, item) if item.is_structure else item

    def named(self, name: str) -> Iterator[Item]:
        """Every item of this name, in any case."""
        wanted = name.lower()
        return (item for item in self.items.values() if item.name.lower() == wanted)


def load(name: str, version: str = "") -> Schema:
    """The schema of a table, as one version knows it."""
    return schema_of(table(name), version)


def schema_of(rows: Iterable[Mapping[str, str]], version: str = "") -> Schema:
    """The schema of rows, as one version knows it: a column of that name says what it makes of each. What holds other
    names and has no row of its own is a group."""
    items: dict[str, Item] = {}
    paths = set()
    for row in rows:
        paths.add(row["path"])
        status = row[version] if version else "yes"
        if status != "no":
            items[row["path"]] = _item(row, status, version)
    top = Item("", "group")
    for path in list(items):
        while (path := parent_of(path)) and path not in paths:
            items.setdefault(path, Item(path, "group"))
    for path, item in items.items():
        owner = items.get(parent_of(path)) if parent_of(path) else top
        if owner is not None:
            (owner.attributes if item.is_attribute else owner.children)[item.name] = item
    return Schema(items, top)


def parent_of(path: str) -> str:
    """The path of what holds an item; empty at the top."""
    return path.rpartition("@" if "@" in path else "/")[0]


def listed(words: Sequence[str]) -> str:
    """``a, b or c``."""
    return " or ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def _item(row: Mapping[str, str], status: str, version: str) -> Item:
    return Item(
        row["path"],
        for_version(row["type"], version),
        for_version(row.get("allowed", ""), version),
        tuple(row["aliases"].split(",")) if row.get("aliases") else (),
        row.get("required") == "yes",
        row.get("max") == "1",
        int(row.get("order") or 0),
        row.get("since", ""),
        status,
        row,
    )


def for_version(cell: str, version: str) -> str:
    """The part of a cell ``A ; 0.7,0.8: B`` that counts for a version."""
    newest, *older = cell.split(" ; ")
    for part in older:
        versions, _, value = part.partition(": ")
        if version in versions.split(","):
            return value
    return newest.strip()
