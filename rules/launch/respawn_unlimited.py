"""A process is restarted without end.

## What it finds
`respawn=True` without `respawn_max_retries` on Jazzy and later, and the argument `respawn_max_retries` on
distributions that do not have it.

## Why it matters on a robot
Without a limit a broken driver is restarted for ever and nobody escalates. Before Jazzy the keyword is a TypeError: the
launch file cannot be loaded.

## Bad
```python
Node(package='lidar', executable='lidar_node', respawn=True, respawn_delay=2.0)
```

## Good
```python
Node(package='lidar', executable='lidar_node', respawn=True, respawn_delay=2.0, respawn_max_retries=10)
```

## References
- launch, `ExecuteLocal`: `respawn_max_retries` is -1 by default
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import rule

WITHOUT = ("foxy", "galactic", "humble", "iron")


@rule("info", symptoms=["unexpected keyword argument 'respawn_max_retries'"])
def respawn_unlimited(robot: Robot) -> Iterator[Finding]:
    ros = robot.target.ros
    if ros is None:
        return
    for node in robot.launch.nodes:
        if not isinstance(node.action, launch.Process):
            continue
        limit = node.action.options.get("respawn_max_retries")
        if ros in WITHOUT and limit is not None and node.file.format == "python":
            yield finding(
                limit.span,
                f"respawn_max_retries does not exist on {ros}: the launch file cannot be loaded",
                advice="remove it, or limit the restarts of the unit",
                severity="error",
            )
        elif ros not in WITHOUT and limit is None and launch.respawns(node) and not node.action.open:
            yield finding(
                node.action.options["respawn"].span,
                f"{node.label()} is restarted without end",
                advice="set respawn_max_retries",
            )
