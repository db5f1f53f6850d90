"""A lifecycle manager lists a node that has no lifecycle.

## What it finds
Entries of `node_names` that name a node without a lifecycle, such as `usb_cam` or `sllidar_ros2`.

## Why it matters on a robot
The node's `change_state` service never appears. The manager waits for it, and the bring-up stops there.

## Bad
```python
Node(package='usb_cam', executable='usb_cam_node_exe', name='camera'),
Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager',
     parameters=[{'autostart': True, 'node_names': ['camera', 'map_server']}]),
```

## Good
```python
Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager',
     parameters=[{'autostart': True, 'node_names': ['map_server']}]),
```

## When to ignore it
When you run a fork of the driver that implements the lifecycle under the same package and executable name.

## References
- ROS 2 design, "Managed nodes"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["change_state service"])
def lifecycle_non_lifecycle_node(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        started = {launch.full_name(node, robot.launch.role(node)): node for node in expansion.nodes}
        for manager in launch.managers(expansion):
            for managed in manager.managed or ():
                node = started.get(managed.fqn)
                if node is None or getattr(node.action, "lifecycle", False):
                    continue
                if robot.launch.role(node).managed is False:
                    yield finding(
                        managed.name,
                        f"{launch.literal_text(node.package)} is not a lifecycle node: the manager waits for"
                        f" {managed.fqn}/change_state and the bring-up stops",
                        advice="remove it from node_names",
                        related=[note(node.span, "the node is started here")],
                        chain=robot.provenance.chain_to(managed.name, f"the manager waits for {managed.fqn}"),
                    )
