"""What makes a timer elapse."""

from __future__ import annotations

from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.spelling import nearest

TRIGGERS = (
    "OnActiveSec",
    "OnBootSec",
    "OnStartupSec",
    "OnUnitActiveSec",
    "OnUnitInactiveSec",
    "OnCalendar",
    "OnClockChange",
    "OnTimezoneChange",
)


class Misspelt(NamedTuple):
    """A key that systemd does not know, and the trigger that was meant."""

    key: Located
    meant: str


def has_trigger(unit: Unit) -> bool:
    return any(unit.has(key, "Timer") for key in TRIGGERS)


def misspelt_trigger(unit: Unit) -> Misspelt | None:
    """The first key of a timer without a trigger that was meant as one."""
    if unit.type != "timer" or has_trigger(unit):
        return None
    for key in (line.key for file in unit.files for section in file.sections for line in section.assignments):
        meant = nearest(key, TRIGGERS) if key not in TRIGGERS else []
        if len(meant) == 1:
            return Misspelt(key, meant[0])
    return None
