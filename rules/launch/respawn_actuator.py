"""launch restarts a motor driver automatically.

## What it finds
`respawn=True` on nodes that are known to be hardware interfaces of motors.

## Why it matters on a robot
After a crash the driver is back within seconds, in an unknown state, and obeys whatever command comes next. The
robot may jump while somebody has their hands in it.

## Bad
```python
Node(package='controller_manager', executable='ros2_control_node', respawn=True, respawn_delay=2.0)
```

## Good
```python
Node(package='controller_manager', executable='ros2_control_node', on_exit=Shutdown())
```

## When to ignore it
When the motor controller itself, or a safety relay, keeps the drives off until somebody resets it.

## References
- ISO 12100, prevention of unexpected start-up
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import rule


@rule("warning", silent="launch reports only that a process has died and that one has started")
def respawn_actuator(robot: Robot) -> Iterator[Finding]:
    for node in robot.launch.nodes:
        if not isinstance(node.action, launch.Node) or robot.launch.simulated(node.file):
            continue
        if launch.literal_text(node.executable) == "spawner" or launch.respawns(node) is not True:
            continue
        if robot.launch.role(node).role == "hardware":
            yield finding(
                node.action.options["respawn"].span,
                f"{node.label()} restarts automatically after a crash, without a safe state",
                advice="shut the launch down instead (on_exit=Shutdown()) and restart under supervision",
            )
