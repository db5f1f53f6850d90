"""One tag of a launch file, whether it is written in XML or YAML."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Union

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.source import Located
from bringup_lint.source import Span

Attribute = Union[Located, list[Located]]


@dataclass(eq=False, slots=True)
class Entity:
    tag: Located
    span: Span
    attributes: dict[str, Attribute] = field(default_factory=dict)
    children: list[Entity] = field(default_factory=list)
    keys: dict[str, Located] = field(default_factory=dict)
    """The attributes' names, where they are written."""

    def get(self, *names: str) -> Located | None:
        """The first of these attributes that is there as one text."""
        for name in names:
            value = self.attributes.get(name)
            if isinstance(value, Located):
                return value
        return None

    def named(self, *tags: str) -> Iterator[Entity]:
        """The direct children of these tags."""
        return (child for child in self.children if child.tag in tags)
