"""The journal labels the robot's log lines "bash".

## What it finds
A ROS service that starts through a shell, without SyslogIdentifier=. Services whose output does not go to the
journal are exempt.

## Why it matters on a robot
systemd labels the lines with the program of ExecStart=: all services appear as "bash", and `journalctl -t`
cannot select one.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
SyslogIdentifier=rover-base
```

## When to ignore it
When you select logs by unit only (`journalctl -u`), which always works.

## References
- systemd.exec(5), SyslogIdentifier=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="the lines of the program are there, only under the name of the shell")
def syslogidentifier_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        shells = [process for process in robot.units.started(unit) if process.shell]
        output = unit.get("StandardOutput") or "journal"
        if (
            not shells
            or not unit.complete
            or unit.get("SyslogIdentifier")
            or output.startswith(("null", "file:", "append:"))
        ):
            continue
        yield finding(
            unit.where,
            f'The journal labels the lines of {unit.name} "{shells[0].name}"',
            advice=f"set SyslogIdentifier={unit.stem.partition('@')[0]}",
        )
