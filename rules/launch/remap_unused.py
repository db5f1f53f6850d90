"""A remapping never matches.

## What it finds
Remappings of an absolute topic (`/image_raw`) on nodes that are known to use the relative one. A warning when the
node is in a namespace, info when it is not.

## Why it matters on a robot
In the namespace `/front` the driver publishes `/front/image_raw`. A rule for `/image_raw` does not match that name:
the driver keeps its old topic, and the subscriber to the new one gets nothing.

## Bad
```python
Node(package='usb_cam', executable='usb_cam_node_exe', namespace='front', remappings=[('/image_raw', 'image')])
```

## Good
```python
Node(package='usb_cam', executable='usb_cam_node_exe', namespace='front', remappings=[('image_raw', 'image')])
```

## When to ignore it
When the node is a modified version that publishes the absolute topic, or, for the info finding, when the node will
never get a namespace.

## References
- ROS 2 design, "Topic and Service name mapping"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import rule


@rule("warning", fix="unsafe", silent="rcl does not report remappings that match nothing")
def remap_unused(robot: Robot) -> Iterator[Finding]:
    for node in robot.launch.nodes:
        topics = robot.launch.role(node).topics
        if not topics or node.namespace is None:
            continue
        own = node.namespace.rstrip("/")
        for src, _ in getattr(node.action, "remappings", ()):
            source = launch.literal(src)
            if source is None or not source.startswith("/") or source[1:] not in topics:
                continue
            yield finding(
                source,
                f"'{source}' matches only at the root: in {own} the node keeps using {own}{source}"
                if own
                else f"'{source}' matches only while the node has no namespace: in a namespace it keeps using its own "
                f"{source[1:]}",
                severity=None if own else "info",
                advice=f"remap '{source[1:]}'",
                fix=fix(f"remap '{source[1:]}'", (source, source[1:]), safe=False)
                if source.span.text == source
                else None,
            )
