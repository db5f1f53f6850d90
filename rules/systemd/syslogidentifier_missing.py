"""The journal calls the robot's lines "bash".

## What it finds
A ROS service that is started through a shell, without SyslogIdentifier=.

## Why it matters on a robot
systemd names the lines after the program of ExecStart=: all layers appear as "bash", and `journalctl -t`
cannot tell them apart.

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

## References
- systemd.exec(5), SyslogIdentifier=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info")
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
            f'The journal shows the lines of {unit.name} as "{shells[0].name}"',
            advice=f"set SyslogIdentifier={unit.stem.partition('@')[0]}",
        )
