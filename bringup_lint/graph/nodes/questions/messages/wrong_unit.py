"""A value of a message in another unit than its definition gives, and how percentages are known."""

from __future__ import annotations

from bringup_lint.facts.ros.message_units import ChipUnit
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

PERCENT = 5
"""The smallest number that is surely a percentage; 1.5 and the like ask whether the other side is right."""
TELLS_APART = regex(
    r"\.(?:percentage|relative_humidity)\s{0,4}[<>]=?\s{0,4}[12](?:\.\d{1,3})?(?![\d.])"
    r"|->percentage\s{0,4}[<>]=?\s{0,4}[12](?:\.\d{1,3})?(?![\d.])"
)
"""A comparison that finds out whether a driver publishes shares or percentages."""


class WrongUnit(NamedTuple):
    place: Span
    type: str
    field: str
    is_read: bool
    """A limit for a value that comes in; else the value that goes out."""
    got: str
    """``20`` for a percentage, empty where it is not known; ``degrees``; the unit of a chip."""
    declared: Span | None = None
    """The parameter of which a limit is the default."""
    chip: ChipUnit | None = None
    """The kind of chip whose reading it is."""
