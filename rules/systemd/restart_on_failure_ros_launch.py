"""Restart=on-failure with ros2 launch, which hardly ever fails.

## What it finds
Restart=on-failure, on-abnormal or on-abort on a service whose main process is ros2 launch. If the launch file
is in the tree and respawns all of its nodes itself, or its package is there without it, nothing is reported.

## Why it matters on a robot
ros2 launch keeps running when a node dies, and exits with status 0 after on_exit=Shutdown(). systemd sees a
service that runs or has exited cleanly, and does not restart it: the dead driver stays dead.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
Restart=on-failure
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
Restart=always
```
together with on_exit=Shutdown() for the nodes that are vital to the robot, or respawn=True in the launch
file.

## When to ignore it
When the launch file exits with an error status by itself, or when a clean shutdown must not be followed by a
restart and the nodes respawn.

## References
- <https://github.com/ros2/launch/issues/816>: "process exits with Exit Code = 0"
- systemd.service(5), Restart=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.supervision import every_node_respawns
from bringup_lint.api.supervision import expansion_of
from bringup_lint.api.systemd import Ros

FAILURES = ("on-failure", "on-abnormal", "on-abort")


@rule("warning", fix="unsafe", symptoms=["process has died"])
def restart_on_failure_ros_launch(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service, policy = robot.units.supervision(unit), robot.units.restart(unit)
        if policy.restart not in FAILURES or service.main is None:
            continue
        programs = [found for _, found in service.main_line.launches]
        last = [found for step, found in service.main_line.launches if step.last and service.main.kind == "shell"]
        if not programs or not (service.main.kind == "launch" or last):
            continue
        expansion = expansion_of(programs[-1], robot.launch)
        if every_node_respawns(expansion) if expansion is not None else _is_missing(robot, programs[-1]):
            continue
        yield finding(
            policy.where,
            "ros2 launch keeps running when a node dies, and exits with status 0 after Shutdown(): "
            f"Restart={policy.restart} does not restart {unit.name}",
            advice="set Restart=always, and make launch shut down with a vital node or respawn the nodes itself",
            related=[note(programs[-1].where, "launches this file")],
            confidence="high" if expansion is not None else "medium",
            fix=fix("set Restart=always", (policy.where, "always"), safe=False) if unit.editable else None,
        )


def _is_missing(robot: Robot, program: Ros) -> bool:
    """Whether the package is in the tree and has no such file, with which the service fails at once."""
    return program.package in robot.launch.workspace.packages and "$" not in (program.target or "$")
