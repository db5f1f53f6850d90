"""A lifecycle node is unconfigured after a restart.

## What it finds
`respawn=True` on lifecycle nodes that no lifecycle manager with a bond brings up again.

## Why it matters on a robot
After a crash the process is back, but its state is not. The node stays unconfigured and silent, while everything
looks restarted.

## Bad
```python
LifecycleNode(package='my_lidar', executable='lidar', name='lidar', namespace='', respawn=True, respawn_delay=2.0)
```

## Good
```python
Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager',
     parameters=[{'autostart': True, 'bond_timeout': 4.0, 'node_names': ['lidar']}])
```

## When to ignore it
When the node configures and activates itself at start, or when a supervisor outside this tree does it.

## References
- nav2, lifecycle manager: `attempt_respawn_reconnection`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="launch reports the new process, but not that it is unconfigured")
def respawn_lifecycle(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        if launch.outside(expansion):
            continue
        managers = launch.managers(expansion)
        for node in expansion.nodes:
            lifecycle = getattr(node.action, "lifecycle", False) or robot.launch.role(node).managed
            if (
                not lifecycle
                or launch.respawns(node) is not True
                or getattr(node.action, "autostart", None) is not None
            ):
                continue
            name = launch.full_name(node, robot.launch.role(node))
            own = [each for each in managers if each.managed is None or any(name == item.fqn for item in each.managed)]
            if name is None or any(each.watches is not False for each in own):
                continue
            yield finding(
                getattr(node.action, "options", {})["respawn"].span,
                f"{node.label()} is unconfigured after a restart and stays silent",
                advice="let a lifecycle manager with bond_timeout above 0 bring it up again",
                related=[note(each.node.span, "this manager does not use a bond") for each in own],
            )
