"""A timer that waits for its service to have run once.

## What it finds
A timer whose only triggers are OnUnitActiveSec= and OnUnitInactiveSec=, while nothing else in the tree
names the service that it starts.

## Why it matters on a robot
Both count from the last run of the service. After boot there is none, so the timer waits for ever and
systemctl list-timers shows no next run.

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

## References
- systemd.timer(5): monotonic timers relative to the unit's activation
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_FIRST = ("OnActiveSec", "OnBootSec", "OnStartupSec", "OnCalendar", "OnClockChange", "OnTimezoneChange")
_REPEATED = ("OnUnitActiveSec", "OnUnitInactiveSec")


@rule("warning")
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
            f"{unit.name} waits for {service} to have run once, and nothing runs it a first time",
            advice="add OnBootSec=",
        )


def _named_elsewhere(robot, timer, service):
    """Whether the service is installed for boot, or another file of the tree names it."""
    own = [file.source for file in timer.files]
    target = robot.units.find(service, timer)
    if target is None or any(True for _ in robot.units.wanted_by(target)):
        return True
    own += [file.source for file in target.files]
    return any(service in source.text for source in robot.sources if source not in own)
