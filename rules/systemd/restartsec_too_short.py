"""The service restarts in less than a second.

## What it finds
A service with Restart= that restarts in less than a second: RestartSec= is shorter, or not set (the default
is 100 ms). RestartSec=0 on a service without ROS is a decision and exempt.

## Why it matters on a robot
Serial ports, cameras and network ports need a moment until they are free again. A driver that restarts after
100 ms finds its device busy. Five such failures take less than two seconds. The default start limit then
leaves the service down.

## Bad
```ini
[Service]
ExecStart=/opt/robot/bin/lidar-driver
Restart=on-failure
```

## Good
```ini
[Service]
ExecStart=/opt/robot/bin/lidar-driver
Restart=on-failure
RestartSec=2
```

## When to ignore it
When the service opens no device or port, and its start limit allows the fast restarts.

## References
- systemd.service(5), RestartSec=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import duration


@rule("info", symptoms=["Scheduled restart job, restart counter is at"])
def restartsec_too_short(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        policy = robot.units.restart(unit)
        if not unit.complete or not policy.restarts or not policy.known or policy.delay >= 1:
            continue
        if policy.delay == 0 and unit not in robot.units.ros:
            continue
        unset = "" if policy.delay_at else " (the default)"
        yield finding(
            policy.delay_at or policy.where,
            f"{unit.name} restarts after {duration(policy.delay)}{unset}: its device or port may still be "
            f"busy, and {policy.burst} failures in {duration(policy.interval)} leave it down",
            advice="set RestartSec=2 or more",
            related=[note(policy.where, "enables the restarts")] if policy.delay_at else (),
        )
