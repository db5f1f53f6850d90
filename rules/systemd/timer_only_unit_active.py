"""A timer that never starts its service for the first time.

## What it finds
A timer whose only triggers are OnUnitActiveSec= and OnUnitInactiveSec=, while nothing else in the tree starts
or names its service.

## Why it matters on a robot
Both triggers count from the last run of the service. After boot there is none, so that the timer waits
forever, and systemctl list-timers shows no next run.

## Bad
```ini
[Timer]
OnUnitActiveSec=10min
```

## Good
```ini
[Timer]
OnBootSec=1min
OnUnitActiveSec=10min
```

## When to ignore it
When something outside of this tree, such as an operator or a fleet agent, starts the service for the first
time.

## References
- systemd.timer(5): monotonic timers relative to the unit's activation
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit

_FIRST = ("OnActiveSec", "OnBootSec", "OnStartupSec", "OnCalendar", "OnClockChange", "OnTimezoneChange")
_REPEATED = ("OnUnitActiveSec", "OnUnitInactiveSec")


@rule("warning", silent="the timer is active and has no next elapse")
def timer_only_unit_active(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        if unit.type != "timer" or unit.fragment is None or unit.uncertain:
            continue
        if any(unit.has(key, "Timer") for key in _FIRST):
            continue
        repeated = [value for key in _REPEATED for value in unit.values(key, "Timer")]
        service = str(unit.get("Unit", "Timer") or f"{unit.stem}.service")
        if not repeated or _named_elsewhere(robot, unit, service):
            continue
        yield finding(
            repeated[0],
            f"{unit.name} counts from the last run of {service}, and nothing starts it for the first time",
            advice="add OnBootSec=",
        )


def _named_elsewhere(robot: Robot, timer: Unit, service: str) -> bool:
    """Whether the service is installed for boot, or another file of the tree names it."""
    own = [file.source for file in timer.files]
    target = robot.units.find(service, timer)
    if target is None or any(True for _ in robot.units.wanted_by(target)):
        return True
    own += [file.source for file in target.files]
    return any(service in source.said for source in robot.sources if source not in own)
