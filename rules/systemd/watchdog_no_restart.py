"""The watchdog kills the service, and nothing restarts it.

## What it finds
WatchdogSec= together with Restart=no (the default), on-success or on-abort. None of them restarts the service
after a watchdog timeout.

## Why it matters on a robot
The purpose of the watchdog is to get a hung driver running again. Without a restart, it turns a hang into a
dead driver.

## Bad
```ini
[Service]
Type=notify
ExecStart=/opt/robot/bin/base-driver
WatchdogSec=10
```

## Good
```ini
[Service]
Type=notify
ExecStart=/opt/robot/bin/base-driver
WatchdogSec=10
Restart=on-failure
RestartSec=2
```

## When to ignore it
When OnFailure= brings the robot to a safe state, and an operator must decide before it runs again.

## References
- systemd.service(5), table "Exit causes and the effect of the Restart= settings"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import duration

IDLE = ("no", "on-success", "on-abort")


@rule("warning", symptoms=["Failed with result 'watchdog'"])
def watchdog_no_restart(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        if not unit.has("WatchdogSec"):
            continue
        service, policy = robot.units.supervision(unit), robot.units.restart(unit)
        if not unit.complete or not service.watchdog_on or policy.restart not in IDLE:
            continue
        yield finding(
            service.watchdog.where,
            f"After a watchdog timeout of {duration(service.watchdog.value or 0.0)}, {unit.name} stays dead: "
            f"Restart={policy.restart} does not restart it",
            advice="set Restart=on-failure or on-watchdog",
            related=[note(policy.restart_at, "does not restart after a watchdog timeout")] if policy.restart_at else (),
        )
