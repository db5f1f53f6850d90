"""A ROS 2 command that stays in the foreground in a Type=forking service.

## What it finds
Type=forking where ExecStart= runs ros2 launch, ros2 run or an installed node in the foreground, directly or
as the last command of its shell.

## Why it matters on a robot
systemd waits for the process to return. It never returns, so that systemd kills all processes after
TimeoutStartSec (90 s). With Restart= this repeats forever.

## Bad
```ini
[Service]
Type=forking
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch robot_bringup bringup.launch.py'
```

## Good
```ini
[Service]
Type=exec
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch robot_bringup bringup.launch.py'
```

## When to ignore it
When the program forks by itself, which ros2 launch, ros2 run and ordinary nodes never do.

## References
- systemd.service(5), "Type="
- journal: "start operation timed out. Terminating."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "start operation timed out. Terminating",
        "Can't open PID file * (yet?) after start",
    ],
)
def forking_with_ros(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        kind = unit.get("Type")
        if kind != "forking":
            continue
        for process in robot.units.started(unit):
            started = [ros for step, ros in process.ros if not step.command.background]
            if started and process.replaces_shell:
                what = {"launch": "ros2 launch", "run": "ros2 run"}.get(started[0].kind, "The program")
                yield finding(
                    kind,
                    f"{what} does not fork: {unit.name} reaches its start timeout and is killed",
                    advice="use Type=exec",
                    related=[note(process.program, "the process that stays in the foreground")],
                    fix=fix("use Type=exec", (kind, "exec"), safe=False),
                )
                break
