"""ros2 launch is stopped with a signal at which it leaves its nodes alone.

## What it finds
A service that runs ros2 launch with KillSignal= unset (SIGTERM) or another signal than SIGINT.

## Why it matters on a robot
On SIGINT ros2 launch stops its nodes one after the other: SIGINT, then SIGTERM, then SIGKILL, and runs its
shutdown handlers. On SIGTERM it simply exits. Nodes then die without their safe state, or stay behind.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
KillSignal=SIGINT
TimeoutStopSec=20
```

## References
- systemd.kill(5), KillSignal=
- <https://github.com/ros2/launch/issues/666>
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

THEN = {
    "control-group": "and every node gets the signal at the same time",
    "mixed": "and systemd kills them with SIGKILL",
    "process": "and they keep running",
    "none": "and they keep running",
}


@rule("warning", fix="safe", symptoms=["using SIGTERM or SIGQUIT can result in orphaned processes"])
def kill_signal_not_sigint(robot: Robot):
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        launches = [found for process in robot.units.started(unit) for _, found in process.launches]
        signal = service.kill_signal
        if not launches or not unit.complete or signal.value in ("SIGINT", None) or unit.get("Type") == "oneshot":
            continue
        if service.in_container:
            continue
        change = (signal.at, "SIGINT") if signal.at else unit.new_line("Service", "KillSignal=SIGINT")
        yield finding(
            signal.at or unit.where,
            f"{unit.name} is stopped with {signal.value}, at which ros2 launch exits without stopping "
            f"its nodes, {THEN.get(service.kill_mode.value, THEN['control-group'])}",
            advice="set KillSignal=SIGINT",
            related=[note(found.where, "ros2 launch is started here") for found in launches],
            fix=fix("stop it with SIGINT", change) if unit.editable else None,
        )
