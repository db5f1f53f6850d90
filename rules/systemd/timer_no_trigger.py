"""A timer without a trigger: systemd refuses it.

## What it finds
A timer unit without OnActiveSec=, OnBootSec=, OnStartupSec=, OnUnitActiveSec=, OnUnitInactiveSec=,
OnCalendar=, OnClockChange= or OnTimezoneChange=, after all drop-ins.

## Why it matters on a robot
systemd refuses the timer. The backup, the log rotation or the health check that it should start never runs.

## Bad
```ini
[Timer]
Unit=robot-backup.service
```

## Good
```ini
[Timer]
OnCalendar=daily
Unit=robot-backup.service
```

## When to ignore it
When a drop-in outside of this tree adds the trigger.

## References
- systemd.timer(5)
- journal: "Timer unit lacks value setting. Refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_TRIGGERS = (
    "OnActiveSec",
    "OnBootSec",
    "OnStartupSec",
    "OnUnitActiveSec",
    "OnUnitInactiveSec",
    "OnCalendar",
    "OnClockChange",
    "OnTimezoneChange",
)


@rule("error", symptoms=["Timer unit lacks value setting"])
def timer_no_trigger(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        if unit.type != "timer" or unit.fragment is None or unit.uncertain:
            continue
        if not any(unit.has(key, "Timer") for key in _TRIGGERS):
            yield finding(
                unit.where,
                f"{unit.name} has no trigger: systemd refuses it",
                advice="add OnCalendar= or OnBootSec=",
            )
