"""A remapping never matches.

## What it finds
- Remappings of an absolute topic (`/image_raw`) on nodes that are known to use the relative one. A warning when the
  node is in a namespace, info when it is not.
- Remappings of a name that the node does not use: `imu/data` of navsat_transform_node, which subscribes to `imu`. All
  names are known of nodes whose sources are in the tree and name no other, and of robot_state_publisher,
  joint_state_publisher, teleop_twist_joy, teleop_twist_keyboard, twist_mux, joy, robot_localization, slam_toolbox,
  amcl, velocity_smoother, the spawner of controllers, depth_image_proc and some filters of sensor data. It is info
  where the remapping only takes the slash away, and where the node uses the name already that it would get, unless two
  are to get it.
- Remappings of a relative name in a namespace, where the source names the absolute one (`/cmd_vel`), and the reverse.

Remappings that reach several nodes are left alone when one of them uses the name or is not known.

## Why it matters on a robot
In the namespace `/front` the driver publishes `/front/image_raw`. A rule for `/image_raw` does not match that name:
the driver keeps its old topic, and the subscriber to the new one gets nothing. A rule for a name that the node does
not have is dropped without a message in the same way: navsat_transform_node waits for an orientation forever, and a
controller whose remapping is on the robot_state_publisher beside it hears no velocity.

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
never get a namespace. When the remapping is for a version of the node that has the topic.

## References
- ROS 2 design, "Topic and Service name mapping"
- robot_localization, navsat_transform.cpp: the subscription to `imu`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule("warning", fix="unsafe", silent="rcl does not report remappings that match nothing")
def remap_unused(robot: Robot) -> Iterator[Finding]:
    yield from of_other_names(robot)
    for node in robot.launch.nodes:
        relative = robot.launch.role(node).topics
        if not relative or node.namespace is None:
            continue
        own = node.namespace.rstrip("/")
        for src, _ in getattr(node.action, "remappings", ()):
            source = launch.literal(src)
            if source is None or not source.startswith("/") or source[1:] not in relative:
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


def of_other_names(robot: Robot) -> Iterator[Finding]:
    """One finding for the names that a node does not have, and one for each that it has in another namespace."""
    without: dict[Span, list[topics.DeadRemapping]] = {}
    for each in topics.dead_remappings(robot.topics):
        package = launch.literal_text(each.node.started.package) or ""
        if package not in robot.launch.workspace.packages and robot.dependencies.is_forked(package):
            continue
        if each.used is None:
            without.setdefault(each.node.started.span, []).append(each)
            continue
        yield finding(
            each.source,
            f"{each.node.label()} uses {each.used}, which is another name than '{each.source}' in the namespace "
            f"{each.node.namespace}: the remapping has no effect",
            advice=f"remap '{each.used}'",
            related=[note(each.used, "the name in the source")],
            chain=robot.provenance.chain_to_node(each.node.started),
            confidence="medium",
        )
    yield from (not_there(robot, *group) for group in without.values())


def not_there(robot: Robot, first: topics.DeadRemapping, *others: topics.DeadRemapping) -> Finding:
    started = first.node.started
    program = launch.literal_text(started.plugin) or launch.literal_text(started.executable)
    names = ", ".join(first.instead[:6])
    is_one = any(launch.same(first.target, each.target) for each in others)
    return finding(
        first.source,
        f"{first.node.label()} ({program} of {launch.literal_text(started.package)}) has no topic or service "
        f"'{first.source}': the remapping has no effect",
        advice=f"remap what this node has ({names}), or remove it; if another node has the name, remap it there"
        if names
        else "remove it; if another node has the name, remap it there",
        related=[note(each.source, f"it has no '{each.source}' either") for each in others],
        chain=robot.provenance.chain_to_node(started),
        severity="info" if all(each.harmless for each in (first, *others)) and not is_one else None,
        confidence="medium",
    )
