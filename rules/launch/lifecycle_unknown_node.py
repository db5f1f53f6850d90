"""A lifecycle manager waits for a node that is not started.

## What it finds
Entries of `node_names` that no node of the launch graph has as its name, resolved in the manager's namespace.

## Why it matters on a robot
The manager waits for the services of a node that never starts, or aborts the bring-up. None of its nodes is
activated.

## Bad
```python
Node(package='my_camera', executable='camera', name='camera_front'),
Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager',
     parameters=[{'autostart': True, 'node_names': ['camera_driver']}]),
```

## Good
```python
Node(package='my_camera', executable='camera', name='camera_front'),
Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager',
     parameters=[{'autostart': True, 'node_names': ['camera_front']}]),
```

## When to ignore it
When something outside this tree starts the node, such as a separate service or another computer.

## References
- https://github.com/ros-navigation/navigation2/issues/1447
- https://github.com/ros-navigation/navigation2/issues/4350
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.supervision import Unstarted
from bringup_lint.api.supervision import unstarted


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "Waiting for service",
        "Failed to change state for node",
        "Failed to bring up all requested nodes. Aborting bringup.",
    ],
)
def lifecycle_unknown_node(robot: Robot) -> Iterator[Finding]:
    for missing in unstarted(robot.launch, robot.params):
        managed, near = missing.managed, missing.near
        message, advice = _described(robot, missing)
        exact = len(near) == 1 and missing.namesake is None and managed.name.span.text == managed.name
        yield finding(
            managed.name,
            message,
            advice=advice,
            related=[note(missing.started[name].span, f"node '{name}' is started here") for name in near[:3]]
            or [note(missing.manager.node.span, "the manager")],
            chain=robot.provenance.chain_to(managed.name, f"the manager waits for {managed.fqn}"),
            fix=fix(f"list '{near[0]}'", (managed.name, near[0]), safe=False) if exact else None,
        )


def _described(robot: Robot, missing: Unstarted) -> tuple[str, str]:
    """The message and the advice."""
    fqn, near, namesake = missing.managed.fqn, missing.near, missing.namesake
    if namesake is not None:
        is_called = launch.full_name(namesake, robot.launch.role(namesake))
        return (
            f"The manager looks for {fqn}, but the node is {is_called}",
            "start the manager in the namespace of its nodes",
        )
    advice = f"list '{near[0]}'" if near else "remove it from node_names, or start the node"
    return f"No node {fqn} is started: the manager waits for it and brings nothing up", advice
