"""Scalar settings of a unit as systemd takes them: the last assignment that it does not ignore.

Per the systemd source (``src/shared/conf-parser.c``): an empty or malformed value of a number, time span,
boolean or word is ignored with a warning, and what an earlier line said stays.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING
from typing import NamedTuple
from typing import TypeVar

from bringup_lint.parsers.systemd_values import parse_bool
from bringup_lint.parsers.systemd_values import parse_timespan
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.unit import Unit

Value = TypeVar("Value")


class Setting(NamedTuple):
    """What a scalar setting amounts to."""

    at: Located | None
    """The value that wins; None when nothing sets it."""
    value: object
    """As read; None when it is unset, or cannot be known (a template's placeholder)."""

    @property
    def unknown(self) -> bool:
        return self.at is not None and self.value is None


def setting(unit: Unit, read: Callable[[str], Value | None], *keys: tuple[str, str]) -> Setting:
    """The last assignment to one of the (key, section) pairs that ``read`` accepts (it gives None for what
    systemd would ignore)."""
    found = Setting(None, None)
    for file in unit.files:
        for assignment in file.assignments:
            if (str(assignment.key), str(assignment.section)) not in keys:
                continue
            if assignment.opaque:
                found = Setting(assignment.value, None)
            elif assignment.value and (value := read(assignment.value)) is not None:
                found = Setting(assignment.value, value)
    return found


def flag(unit: Unit, key: str, section: str = "Service") -> Setting:
    return setting(unit, parse_bool, (key, section))


def seconds(unit: Unit, *keys: str, section: str = "Service") -> Setting:
    """A time span in seconds; several keys are spellings of one setting (TimeoutSec= and TimeoutStopSec=)."""
    return setting(unit, parse_timespan, *((key, section) for key in keys))


def word(unit: Unit, key: str, choices: frozenset[str], section: str = "Service") -> Setting:
    """One of several words."""
    return setting(unit, lambda text: text if text in choices else None, (key, section))


def duration(span: float) -> str:
    """Seconds as people write them: ``100 ms``, ``5 s``, ``3 min``."""
    if 0 < span < 1:
        return f"{span * 1000:g} ms"
    return f"{span / 60:g} min" if span >= 180 and span % 60 == 0 else f"{round(span, 1):g} s"
