"""Some nodes of a namespaced robot use the global tf tree.

## What it finds
Launch files in which some nodes remap `/tf` into their namespace, while other nodes of the same namespace use tf
without the remapping.

## Why it matters on a robot
`/tf` is an absolute name, so a namespace does not change it. Half of the nodes use the frames of this robot, and
half use those of all robots. Transforms are missing, or come from another robot.

## Bad
```python
Node(package='nav2_amcl', executable='amcl', namespace='robot1',
     remappings=[('/tf', 'tf'), ('/tf_static', 'tf_static')]),
Node(package='nav2_planner', executable='planner_server', namespace='robot1'),
```

## Good
```python
remappings = [('/tf', 'tf'), ('/tf_static', 'tf_static')]
Node(package='nav2_amcl', executable='amcl', namespace='robot1', remappings=remappings),
Node(package='nav2_planner', executable='planner_server', namespace='robot1', remappings=remappings),
```

## When to ignore it
When the node must see the transforms of all robots, for example a fleet map, and its frame names carry a prefix per
robot.

## References
- https://github.com/ros-navigation/navigation2/issues/4552
- https://github.com/ros-navigation/navigation2/issues/3376
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import with_items

USES_TF = ("localization", "planning", "control", "mapping", "costmap")
PUBLISHERS = (("robot_state_publisher", "robot_state_publisher"), ("tf2_ros", "static_transform_publisher"))


@rule("warning", fix="unsafe", symptoms=["Timed out waiting for transform from * to * to become available, tf error:"])
def tf_not_remapped(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        remapping: dict[str | None, launch.Started] = {}
        for node in expansion.nodes:
            if node.by_default is not False and node.namespace not in (None, "/") and moves_tf(node):
                remapping.setdefault(node.namespace, node)
        for node in expansion.nodes:
            other = remapping.get(node.namespace)
            if other is None or node.by_default is False or moves_tf(node):
                continue
            program = (launch.literal_text(node.package), launch.literal_text(node.executable))
            if robot.launch.role(node).role in USES_TF or program in PUBLISHERS:
                change = with_items(node.span, "remappings", "('/tf', 'tf')", "('/tf_static', 'tf_static')")
                yield finding(
                    node.span,
                    f"{node.label()} uses the global /tf, but other nodes of {node.namespace} use their own: "
                    "transforms are missing",
                    advice="remap ('/tf', 'tf') and ('/tf_static', 'tf_static') here too",
                    related=[note(other.span, "remaps /tf")],
                    fix=fix("remap /tf and /tf_static", codemod=change, safe=False) if change else None,
                )


def moves_tf(node: launch.Started) -> bool:
    """Whether a node has its own transforms; what is not known may move them."""
    return any(
        launch.literal_text(src) in ("/tf", "tf", None) and launch.literal_text(dst) != "/tf"
        for src, dst in node.remappings
    )
