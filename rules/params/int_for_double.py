"""A parameter that is declared as a double gets an integer.

## What it finds
Integers in a parameter file or launch file for parameters that the sources of the workspace declare as a double, with a
literal name and type; the text of a launch argument counts as what YAML makes of it. The same for nodes of Navigation2
with its own plugins, slam_toolbox, robot_localization, twist_mux, teleop_twist_joy, joy, usb_cam, sllidar_ros2,
pointcloud_to_laserscan and the controllers of ros2_controllers, which a launch file gives the value or the file, or a
block of it names, and for the limits of a `joint_limits.yaml` beside an SRDF, which MoveIt reads. Silent where the node
allows any type, or declares the name with several types.

## Why it matters on a robot
ROS does not convert the value: the node exits with InvalidParameterTypeException at start. A controller
of ros2_control is not loaded.

## Bad
```yaml
motors:
  ros__parameters:
    max_speed: 1
```

## Good
```yaml
motors:
  ros__parameters:
    max_speed: 1.0
```

## When to ignore it
When the declaration that the linter found belongs to another node than the one that loads the file.

## References
- https://github.com/ros2/rclcpp/issues/979
- https://github.com/ros-controls/ros2_controllers/issues/136
- https://github.com/moveit/moveit2/issues/2776
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.params import wrong_types

_DECIMAL = regex(r"[+-]?(?:0|[1-9][0-9]*)\Z")


@rule(
    "warning",
    fix="safe",
    symptoms=[
        "has invalid type: expected [double] got [integer]",
        "InvalidParameterTypeException",
        "of type {integer}",
        "expecting type {double}",
        "is of type {double}, setting it to {integer} is not allowed",
    ],
)
def int_for_double(robot: Robot) -> Iterator[Finding]:
    for each in wrong_types(robot.params, "integer", "double"):
        if each.package and robot.dependencies.is_forked(each.package):
            continue
        plain = all(_DECIMAL.match(item.text) and not item.quoted for item in each.items)
        yield finding(
            each.where,
            f"'{each.name}: {each.text}' is an integer, but {each.node} declares a double: {each.outcome}",
            advice=f"write {each.items[0].text}.0" if plain else "write a number with a decimal point",
            related=[note(each.declared, "declared as a double here")] if each.declared else [],
            chain=robot.provenance.chain_to_node(each.started) if each.started is not None else (),
            fix=fix("write a double", *((item.span, f"{item.text}.0") for item in each.items)) if plain else None,
        )
