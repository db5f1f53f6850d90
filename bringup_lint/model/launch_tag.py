"""A tag of an XML or YAML launch file as it is written, before anything is made of it."""

from __future__ import annotations

from typing import Union

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Span

Plain = Union[str, int, float, bool, None]


@dataclass(eq=False, slots=True)
class Written:
    """An attribute."""

    key: Located
    text: Located
    value: Plain | list[Plain] | object
    """As the front end reads it: in XML always text; in YAML what YAML makes of it."""


@dataclass(eq=False, slots=True)
class Tag:
    name: Located
    place: Span
    """The start tag, or the key."""
    attributes: dict[str, Written] = field(default_factory=dict)
    lists: dict[str, list[Tag]] = field(default_factory=dict)
    """Children by their tag; in YAML the lists of maps under a key."""
    keys: dict[str, Located] = field(default_factory=dict)
    """The first place of each name in ``lists``."""
    actions: list[Tag] | None = None
    """All children in order; None in YAML when there is no list of them."""
    problems: list[Problem] = field(default_factory=list)
    """What the front end refuses whatever the tag is: ``not-a-list``, ``several-keys``, ``no-map``, ``empty-list``."""
    form: str = "xml"
    """``xml``, ``map`` or ``list``."""
