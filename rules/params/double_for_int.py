"""A parameter that is declared as an integer gets a double.

## What it finds
Doubles in a parameter file or launch file for parameters that the sources of the workspace declare as an integer, with
a literal name and type; the text of a launch argument counts as what YAML makes of it. The same for nodes of
Navigation2 with its own plugins, slam_toolbox, robot_localization, twist_mux, teleop_twist_joy, joy, usb_cam,
sllidar_ros2, the controller manager and the controllers of ros2_controllers, which a launch file gives the value or the
file, or a block of it names. Silent where the node allows any type, or declares the name with several types.

## Why it matters on a robot
ROS does not convert the value: the node exits with InvalidParameterTypeException at start. A controller
of ros2_control is not loaded.

## Bad
```yaml
motors:
  ros__parameters:
    baudrate: 115200.0
```

## Good
```yaml
motors:
  ros__parameters:
    baudrate: 115200
```

## When to ignore it
When the declaration that the linter found belongs to another node than the one that loads the file.

## References
- https://github.com/ros2/rclcpp/issues/979
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

_WHOLE = regex(r"([+-]?(?:0|[1-9][0-9]*))\.0*\Z")


@rule(
    "warning",
    fix="safe",
    symptoms=[
        "has invalid type: expected [integer] got [double]",
        "InvalidParameterTypeException",
        "of type {double}",
        "expecting type {integer}",
        "is of type {integer}, setting it to {double} is not allowed",
    ],
)
def double_for_int(robot: Robot) -> Iterator[Finding]:
    for each in wrong_types(robot.params, "double", "integer"):
        if each.package and robot.dependencies.is_forked(each.package):
            continue
        whole = [match[1] for item in each.items if not item.quoted and (match := _WHOLE.match(item.text))]
        plain = len(whole) == len(each.items)
        yield finding(
            each.where,
            f"'{each.name}: {each.text}' is a double, but {each.node} declares an integer: {each.outcome}",
            advice=f"write {whole[0]}" if plain else "write a whole number",
            related=[note(each.declared, "declared as an integer here")] if each.declared else [],
            chain=robot.provenance.chain_to_node(each.started) if each.started is not None else (),
            fix=fix("write an integer", *((item.span, text) for item, text in zip(each.items, whole)))
            if plain
            else None,
        )
