"""Two nodes have the same name.

## What it finds
Nodes and components of one launch graph with the same fully qualified name. Both start by default, and their
conditions do not exclude each other. Info where both only send a static transform.

## Why it matters on a robot
ROS 2 lets both run. Parameters and services reach one of them by chance, and lifecycle managers and monitors see
one node. The only hint is "Publisher already registered for node name" in a log.

## Bad
```python
Node(package='usb_cam', executable='usb_cam_node_exe', name='camera'),
Node(package='usb_cam', executable='usb_cam_node_exe', name='camera'),
```

## Good
```python
Node(package='usb_cam', executable='usb_cam_node_exe', name='camera_front'),
Node(package='usb_cam', executable='usb_cam_node_exe', name='camera_rear'),
```

## When to ignore it
When the launch file starts only one of the two at run time, by means the linter does not see, such as a condition
inside the node's own start script.

## References
- https://github.com/ros2/launch_ros/issues/124
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule

BY_CHANCE = "which of them answers a parameter or service call is left to chance"
ALIKE = "logs and lists of nodes do not show which is which"


@rule(
    "warning",
    symptoms=[
        "Publisher already registered for node name",
        "nodes with the name * created within this launch context",
    ],
)
def node_duplicate_name(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        first: dict[str, launch.Started] = {}
        for node in expansion.nodes:
            name = node.fqn
            if name is None or node.by_default is not True or loops(node) or node.context:
                continue
            other = first.setdefault(name, node)
            if other is node or launch.exclusive(other, node):
                continue
            places = [note(span, "included here") for span in (*other.chain, *node.chain)]
            is_called = not (sends_only(other) and sends_only(node))
            yield finding(
                launch.literal_text(node.name) or node.span,
                f"Two nodes are called {name}: " + (BY_CHANCE if is_called else ALIKE),
                advice="give each node its own name or namespace",
                related=[note(other.span, "the other node"), *places],
                severity=None if is_called else "info",
            )


def sends_only(node: launch.Started) -> bool:
    """Whether nobody calls the node by its name: it sends its transform, and that is all."""
    return launch.literal(node.executable) == "static_transform_publisher"


def loops(node: launch.Started) -> bool:
    return any(condition.kind == "loop" for condition in node.conditions)
