"""KillMode= that lets nodes survive the stop.

## What it finds
KillMode=process or none on a service that starts ROS 2.

## Why it matters on a robot
Only the main process is stopped. Whatever it does not stop itself keeps running: after a crash of ros2
launch, or with a shell in front of it, the nodes go on driving, and the restart starts them a second time.

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

## References
- systemd.kill(5), KillMode=: process is not recommended, none is deprecated
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="unsafe", symptoms=["left-over process", "Unit configured to use KillMode=none"])
def kill_mode(robot: Robot):
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        mode = service.kill_mode
        if mode.value not in ("process", "none") or unit.get("Type") == "oneshot" or service.in_container:
            continue
        stops = (
            f"only the main process of {unit.name} is stopped"
            if mode.value == "process"
            else f"nothing of {unit.name} is stopped"
        )
        yield finding(
            mode.at,
            f"KillMode={mode.value}: {stops}; nodes that stay behind keep running, and a restart starts them twice",
            advice="set KillMode=mixed",
            fix=fix("kill what is left", (mode.at, "mixed"), safe=False) if unit.editable else None,
        )
