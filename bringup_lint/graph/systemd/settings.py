"""Scalar settings of a unit as systemd takes them: the last assignment that it does not ignore.

Per the systemd source (``src/shared/conf-parser.c``): an empty or malformed value of a number, time span,
boolean or word is ignored with a warning, and what an earlier line said stays.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable

from bringup_lint.dataclass import dataclass
from bringup_lint.model.unit import Assignment
from bringup_lint.parsers.systemd_values import parse_integer
from bringup_lint.source import Located
from bringup_lint.type_names import Generic
from bringup_lint.type_names import TypeVar

Value = TypeVar("Value")


@dataclass(frozen=True)
class Setting(Generic[Value]):
    """What a scalar setting amounts to. It is true where its value is: ``if unit.flag("PrivateTmp")``."""

    at: Located | None
    """The value that wins; None when nothing sets it."""
    value: Value | None
    """As read; None when it is unset, or cannot be known (a template's placeholder)."""

    @property
    def where(self) -> Located:
        """The same for a setting that is known to be set."""
        if self.at is None:
            raise LookupError("nothing sets it")
        return self.at

    @property
    def unknown(self) -> bool:
        return self.at is not None and self.value is None

    def __bool__(self) -> bool:
        return bool(self.value)

    def otherwise(self, default: Value) -> Setting[Value]:
        """The same setting with the value that applies when nothing sets it."""
        return self if self.at is not None else Setting(None, default)


def setting_of(assignments: Iterable[Assignment], read: Callable[[str], Value | None]) -> Setting[Value]:
    """The last assignment that ``read`` accepts (it gives None for what systemd would ignore)."""
    found: Setting[Value] = Setting(None, None)
    for assignment in assignments:
        if assignment.opaque:
            found = Setting(assignment.value, None)
        elif assignment.value and (value := read(assignment.value)) is not None:
            found = Setting(assignment.value, value)
    return found


def one_of(choices: Iterable[str]) -> Callable[[str], str | None]:
    """Reads one of several words."""
    known = frozenset(choices)
    return lambda text: text if text in known else None


def count(text: str) -> int | None:
    """A whole number from 0."""
    value = parse_integer(text)
    return None if value is None or value < 0 else value


def duration(span: float) -> str:
    """Seconds as people write them: ``100 ms``, ``5 s``, ``3 min``."""
    if 0 < span < 1:
        return f"{span * 1000:g} ms"
    return f"{span / 60:g} min" if span >= 180 and span % 60 == 0 else f"{round(span, 1):g} s"
