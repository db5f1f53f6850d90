"""KillMode= lets nodes survive the stop.

## What it finds
KillMode=process or KillMode=none on a service that starts ROS 2. One-shot services and containers are exempt.

## Why it matters on a robot
systemd stops at most the main process. After a crash of ros2 launch, or when the main process is a shell, the
nodes keep driving the robot, and the restart starts them a second time.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
KillMode=process
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
KillSignal=SIGINT
KillMode=mixed
```

## When to ignore it
When processes must outlive the service on purpose, such as a tmux session or a daemon that the service only
starts.

## References
- systemd.kill(5), KillMode=: process is not recommended, none is deprecated
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule(
    "warning",
    fix="unsafe",
    symptoms=["left-over process", "remains running after unit stopped", "Unit configured to use KillMode=none"],
)
def kill_mode(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        mode = service.kill_mode
        if mode.value not in ("process", "none") or unit.get("Type") == "oneshot" or service.in_container:
            continue
        stops = (
            f"systemd stops only the main process of {unit.name}"
            if mode.value == "process"
            else f"systemd stops no process of {unit.name}"
        )
        yield finding(
            mode.where,
            f"KillMode={mode.value}: {stops}; nodes that survive keep running, and a restart starts them twice",
            advice="set KillMode=mixed",
            fix=fix("set KillMode=mixed", (mode.where, "mixed"), safe=False) if unit.editable else None,
        )
