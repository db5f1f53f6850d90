"""launch restarts a process without a limit.

## What it finds
On Jazzy and later: `respawn=True` without `respawn_max_retries` (info). On Foxy to Iron: the argument
`respawn_max_retries` in a Python launch file (error). Silent where the distribution is not known.

## Why it matters on a robot
Without a limit, launch restarts a broken driver forever and nothing escalates the failure. Before Jazzy the keyword
raises a TypeError: the launch file cannot be loaded.

## Bad
```python
Node(package='lidar', executable='lidar_node', respawn=True, respawn_delay=2.0)
```

## Good
```python
Node(package='lidar', executable='lidar_node', respawn=True, respawn_delay=2.0, respawn_max_retries=10)
```

## When to ignore it
When endless restarts are what you want, as for a sensor that may be unplugged for hours. Never ignore the error:
the file cannot be loaded.

## References
- launch, `ExecuteLocal`: `respawn_max_retries` is -1 by default
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import rule
from bringup_lint.api.python import with_keyword
from bringup_lint.api.python import without_keyword

WITHOUT = ("foxy", "galactic", "humble", "iron")


@rule("info", fix="unsafe", symptoms=["unexpected keyword argument 'respawn_max_retries'"])
def respawn_unlimited(robot: Robot) -> Iterator[Finding]:
    ros = robot.target.ros
    if ros is None:
        return
    for node in robot.launch.nodes:
        if not isinstance(node.action, launch.Process):
            continue
        limit = node.action.options.get("respawn_max_retries")
        if ros in WITHOUT and limit is not None and node.file.format == "python":
            drop = without_keyword(limit.span)
            yield finding(
                limit.span,
                f"respawn_max_retries does not exist on {ros}: the launch file cannot be loaded",
                advice="remove it, and limit the restarts of the unit instead",
                severity="error",
                fix=fix("remove respawn_max_retries", codemod=drop) if drop else None,
            )
        elif ros not in WITHOUT and limit is None and launch.respawns(node) and not node.action.open:
            limited = with_keyword(node.action.span, "respawn_max_retries", "5")
            yield finding(
                node.action.options["respawn"].span,
                f"{node.label()} is restarted without a limit",
                advice="set respawn_max_retries",
                fix=fix("allow 5 restarts", codemod=limited, safe=False) if limited else None,
            )
