"""A timer without a trigger: systemd refuses it.

## What it finds
A timer unit without OnActiveSec=, OnBootSec=, OnStartupSec=, OnUnitActiveSec=, OnUnitInactiveSec=,
OnCalendar=, OnClockChange= or OnTimezoneChange=, after all drop-ins. A misspelt trigger is shown with it.

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
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Misspelt
from bringup_lint.api.systemd import has_trigger
from bringup_lint.api.systemd import misspelt_trigger


@rule("error", fix="unsafe", symptoms=["Timer unit lacks value setting"])
def timer_no_trigger(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        if unit.type != "timer" or unit.fragment is None or unit.uncertain:
            continue
        if has_trigger(unit):
            continue
        misspelt = misspelt_trigger(unit)
        yield finding(
            unit.where,
            f"{unit.name} has no trigger: systemd refuses it",
            advice=f"rename {misspelt.key} to {misspelt.meant}" if misspelt else "add OnCalendar= or OnBootSec=",
            related=[note(misspelt.key, "systemd does not know this key")] if misspelt else (),
            fix=_renamed(misspelt) if misspelt else None,
        )


def _renamed(misspelt: Misspelt) -> Fix:
    same = misspelt.key.lower() == misspelt.meant.lower()
    return fix(f"rename to {misspelt.meant}", (misspelt.key, misspelt.meant), safe=same)
