"""The settings of journald.conf, system.conf and logind.conf, and the values that their daemons take."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from functools import cache

from bringup_lint.facts import table
from bringup_lint.model.schema import Item
from bringup_lint.parsers.systemd_values import ValueProblem
from bringup_lint.parsers.systemd_values import check
from bringup_lint.parsers.systemd_values import parse_bool
from bringup_lint.parsers.systemd_values import parse_integer
from bringup_lint.parsers.systemd_values import parse_size
from bringup_lint.parsers.systemd_values import parse_timespan
from bringup_lint.schema.table import schema_of
from bringup_lint.source import Located


@cache
def section_of(daemon: str) -> Item:
    """The only section that ``journald``, ``system`` or ``logind`` reads, with its keys."""
    known = schema_of(row for row in table("systemd/daemon_settings") if row["file"] == daemon)
    return next(iter(known.top.children.values()))


def settings(daemon: str) -> dict[str, Item]:
    """The keys that a daemon knows."""
    return section_of(daemon).children


def since(item: Item) -> int:
    """The first release of systemd that knows a key; 245 stands for older ones, too."""
    return int(item.since)


def value_problems(item: Item, value: Located, version: int) -> Iterator[ValueProblem]:
    """What a daemon finds wrong with a value."""
    if item.type not in _OWN:
        yield from check(item.type, value, version)
        return
    read, expected = _OWN[item.type]
    if read(value) is None:
        yield ValueProblem("invalid", value, expected)


def watchdog_seconds(text: str) -> float | None:
    """Seconds of a watchdog setting; 0 for ``off``, and -1 for ``default``, the driver's own timeout."""
    if text in ("off", "default"):
        return 0.0 if text == "off" else -1.0
    return parse_timespan(text)


def _count(text: str) -> int | None:
    number = parse_integer(text)
    return number if number is not None and 0 <= number < 2**64 else None


def _bool_or_size(text: str) -> int | None:
    flag = parse_bool(text)
    return parse_size(text) if flag is None else int(flag)


_OWN: dict[str, tuple[Callable[[str], object], str]] = {
    "watchdog": (watchdog_seconds, "a time span such as 30s, off or default"),
    "count": (_count, "a whole number"),
    "bool-or-size": (_bool_or_size, "yes, no or a size such as 512"),
    "ignored": (lambda text: text, ""),
}
