"""A fixed sleep before the start hides a race.

## What it finds
ExecStartPre= with no command but sleep.

## Why it matters on a robot
The delay is too short on the one cold morning when the device needs longer, and too long on every other day.
It also does not show what the service waits for.

## Bad
```ini
[Service]
ExecStartPre=/bin/sleep 10
ExecStart=/opt/robot/bin/lidar-driver
```

## Good
```ini
[Unit]
BindsTo=dev-rover-lidar.device
After=dev-rover-lidar.device

[Service]
ExecStart=/opt/robot/bin/lidar-driver
```

## When to ignore it
When a device needs a fixed time after power-on and offers nothing to wait for, such as a motor controller
without a ready signal.

## References
- systemd.device(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="a sleep that is too short shows only in the errors of the program after it")
def execstartpre_sleep(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("sleep"):
        for process in robot.units.processes(unit):
            commands = [step.command for step in process.steps if not step.depth or process.shell]
            names = {command.name for command in commands} - {process.shell}
            if process.key == "ExecStartPre" and names == {"sleep"}:
                yield finding(
                    process.line,
                    f"A fixed sleep hides what {unit.name} waits for, and will be too short one day",
                    advice="wait for the condition itself: a device unit, a socket, or a check",
                )
