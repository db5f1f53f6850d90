"""A timer that never elapses because nothing says when.

## What it finds
A timer unit without any of OnActiveSec=, OnBootSec=, OnStartupSec=, OnUnitActiveSec=, OnUnitInactiveSec=,
OnCalendar=, OnClockChange= and OnTimezoneChange=, after all drop-ins.

## Why it matters on a robot
systemd refuses the timer, so the backup, the log rotation or the health check that it should start never
runs.

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
