"""Shapes of values in YAML and JSON, as the ``type`` column of a table writes them: alternatives of scalars, lists and
mappings, such as ``string or [string or {port}]`` or ``{name:{service}}``."""

from __future__ import annotations

from functools import cache

from bringup_lint.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class Shape:
    """Everything that may be at one place."""

    scalars: frozenset[str] = frozenset()
    """``string``, ``number``, ``integer``, ``boolean``, ``null`` and ``any``."""
    items: Shape | None = None
    """What a list may hold; None where no list may be."""
    structure: str = ""
    """The mapping that the table describes, braces included."""
    names: str = ""
    """The rule for the names of a free mapping: ``*``, ``name`` or ``lower``; empty where none may be."""
    values: Shape | None = None
    """What a free mapping may hold."""

    @property
    def anything(self) -> bool:
        return "any" in self.scalars


@cache
def shape(text: str) -> Shape:
    """Read a cell of the column."""
    scalars, items, structure, names, values = set(), None, "", "", None
    for part in _alternatives(text):
        if part.startswith("["):
            items = shape(part[1:-1])
        elif part.startswith("{") and ":" in part:
            names, _, inner = part[1:-1].partition(":")
            values = shape(inner)
        elif part.startswith("{"):
            structure = part
        else:
            scalars.add(part)
    return Shape(frozenset(scalars), items, structure, names, values)


def _alternatives(text: str) -> list[str]:
    """The parts between ``or`` outside of brackets."""
    parts, depth = [""], 0
    for word in text.split(" "):
        if word == "or" and not depth:
            parts.append("")
            continue
        parts[-1] += f" {word}" if parts[-1] else word
        depth += word.count("[") + word.count("{") - word.count("]") - word.count("}")
    return parts
