"""The controller manager gets no parameters, so that it knows no controller.

## What it finds
A `ros2_control_node` without any parameters, in a launch without a spawner that brings the type of its controller
with `--param-file` or `--controller-type`. Parameters that are set for all nodes count as parameters.

## Why it matters on a robot
The controller manager knows the type of a controller only from its parameters. Without them the spawner ends with
"The 'type' param was not defined", no controller runs, and the robot does not move. Often the path of the file is
there, in a variable that nobody uses.

## Bad
```python
controllers = os.path.join(share, 'config', 'controllers.yaml')
manager = Node(package='controller_manager', executable='ros2_control_node')
spawner = Node(package='controller_manager', executable='spawner', arguments=['base_controller'])
```

## Good
```python
controllers = os.path.join(share, 'config', 'controllers.yaml')
manager = Node(package='controller_manager', executable='ros2_control_node', parameters=[controllers])
spawner = Node(package='controller_manager', executable='spawner', arguments=['base_controller'])
```

## When to ignore it
When something else sets the parameters of the controller manager before the spawners run.

## References
- https://control.ros.org/rolling/doc/ros2_control/controller_manager/doc/userdoc.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import Started

GIVES_TYPE = ("-p", "--param-file", "-t", "--controller-type")


@rule("warning", symptoms=["The 'type' param was not defined for"])
def controller_types_missing(robot: Robot) -> Iterator[Finding]:
    for node in robot.launch.nodes:
        if launch.literal_text(node.executable) != "ros2_control_node" or not node.file.source.judged:
            continue
        if node.parameters or node.arguments or getattr(node.action, "open", False):
            continue
        spawners = [each for around in robot.launch.leading_to(node.file) for each in around.nodes if _spawns(each)]
        if not any(map(_may_give_type, spawners)):
            yield finding(
                node.span,
                "ros2_control_node gets no parameters: it knows the type of no controller, so that none can be loaded",
                advice="give the file of the controllers in parameters=",
                related=[note(each.span, "this spawner fails") for each in spawners[:1]],
                confidence="medium",
            )


def _spawns(node: Started) -> bool:
    return launch.literal_text(node.executable) == "spawner"


def _may_give_type(spawner: Started) -> bool:
    """Whether a spawner brings the type of its controller, or has arguments that are not known."""
    words = [launch.literal_text(value) for value in spawner.arguments]
    return any(word is None or word in GIVES_TYPE for word in words)
