"""The directives of systemd unit files: which section knows which key, since when, with what value."""

from __future__ import annotations

from functools import cache

from bringup_lint import facts
from bringup_lint.named_tuple import NamedTuple

OLDEST = 245
"""The oldest release the tables tell apart."""
NEWEST = 257
"""The newest release the tables cover."""

SECTION_OF_TYPE = {
    "service": "Service",
    "socket": "Socket",
    "mount": "Mount",
    "automount": "Automount",
    "swap": "Swap",
    "timer": "Timer",
    "path": "Path",
    "slice": "Slice",
    "scope": "Scope",
    "target": "Target",
    "device": "Device",
}
"""Unit type (the suffix of its name) to its own section."""


class Directive(NamedTuple):
    section: str
    key: str
    type: str
    """A grammar of ``parsers.systemd_values``; ``ignored`` for keys that are accepted without effect."""
    since: int


class Legacy(NamedTuple):
    section: str
    key: str
    value: str
    """The obsolete value; empty when the key itself is obsolete."""
    replacement: str
    effect: str
    """``renamed``, ``moved:SECTION``, ``ignored`` or ``deprecated``."""
    fix: str
    note: str


@cache
def sections() -> dict[str, dict[str, tuple[str, ...]]]:
    """Section to key to the row of the directive in the table. ``Target`` and ``Device`` exist but have no keys."""
    found: dict[str, dict[str, tuple[str, ...]]] = {name: {} for name in ("Unit", "Install", *SECTION_OF_TYPE.values())}
    for row in facts.rows("systemd/directives")[1]:
        found[row[0]][row[1]] = row
    return found


def directive(section: str, key: str) -> Directive | None:
    row = sections().get(section, {}).get(key)
    return None if row is None else _made(row)


def of_section(section: str) -> list[Directive]:
    return [_made(row) for row in sections()[section].values()]


@cache
def _made(row: tuple[str, ...]) -> Directive:
    section, key, kind, since = row
    return Directive(section, key, kind, int(since))


def sections_of_type(unit_type: str) -> tuple[str, ...]:
    """The sections that a unit of this type may have."""
    own = SECTION_OF_TYPE.get(unit_type)
    return ("Unit", own, "Install") if own else ("Unit", "Install")


def sections_with(key: str) -> list[str]:
    """Every section that knows the key, in the order of the tables."""
    return [name for name, keys in sections().items() if key in keys]


@cache
def legacy() -> dict[tuple[str, str, str], Legacy]:
    """(section, key, value or empty) to what replaces it."""
    found = (Legacy(*row) for row in facts.rows("systemd/legacy")[1])
    return {(row.section, row.key, row.value): row for row in found}
