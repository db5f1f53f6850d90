"""A driver or safety service without a watchdog.

## What it finds
A ROS service without WatchdogSec= whose name marks it as a driver or a safety function. One-shot services,
services that a timer or path unit starts, and containers are exempt.

## Why it matters on a robot
A driver that hangs keeps its process running and its unit "active". Nobody notices that nothing serves the
emergency stop or the motors any more.

## Bad
```ini
# rover-motor-driver.service
[Service]
ExecStart=/opt/ros/jazzy/lib/rover/motor_driver
```

## Good
```ini
[Service]
Type=notify
ExecStart=/opt/ros/jazzy/lib/rover/motor_driver
WatchdogSec=5
Restart=on-failure
```
with a driver that sends WATCHDOG=1 from its control loop.

## When to ignore it
When something else detects the hang, for example the motor controller's own command timeout.

## References
- systemd.service(5), WatchdogSec=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

CRITICAL = regex(
    r"(?:^|[-_.@])(?:drivers?|motors?|base|actuators?|safety|e?-?stop|estop|watchdog|hardware|hw|control(?:ler)?)(?=[-_.@]|$)",
    hints="driver motor base actuator safety stop watchdog hardware hw control",
)


@rule("info", silent="a program that hangs writes no log")
def watchdog_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        if not unit.complete or service.watchdog.at is not None or unit.name in robot.units.triggered:
            continue
        if service.type.value == "oneshot" or service.in_container or not CRITICAL.search(unit.stem):
            continue
        yield finding(
            unit.where,
            f'Nothing notices when {unit.name} hangs: it stays "active"',
            advice="set WatchdogSec= and send WATCHDOG=1 from the control loop",
        )
