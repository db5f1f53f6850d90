"""A misspelt element, attribute or type in a robot description.

## What it finds
In `.urdf` and `.xacro` files: an element that its parent does not have, an attribute that its element does not have,
and the type of a joint or of `<ros2_control>`, that differ by a letter more or less, or by two swapped ones, from
exactly one that is known: those of URDF, of `<ros2_control>` and of SDF in `<gazebo>`. What stands in `<plugin>` is its
own. A file that no launch file and no other description names is a warning.

## Why it matters on a robot
The readers of a description skip what they do not know, without a message: the robot lacks a shape, a limit, an
interface or a sensor. Where the element needs it, robot_state_publisher refuses the whole description (an error).

## Bad
```xml
<link name="mast">
  <colision><geometry><box size="1 1 1"/></geometry></colision>
</link>
```

## Good
```xml
<link name="mast">
  <collision><geometry><box size="1 1 1"/></geometry></collision>
</link>
```

## When to ignore it
When a program of your own reads the element.

## References
- https://wiki.ros.org/urdf/XML
- urdfdom, urdf_parser/src/link.cpp and joint.cpp
- ros2_control, hardware_interface/src/component_parser.cpp
- http://sdformat.org/spec
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "has no known type",
        "Could not parse inertial element for Link",
        "Unable to initialize urdf::model from robot description",
    ],
)
def description_misspelt(robot: Robot) -> Iterator[Finding]:
    for each in robot.plugins.misspelt_words:
        if each.fatal:
            happens = "robot_state_publisher refuses the whole description"
        else:
            happens = f"{each.by} skips it without a message"
        what = f"type '{each.where}'" if each.what == "type" else f"{each.what} '{each.where}'"
        yield finding(
            each.where,
            f"<{each.outer}> has no {what}: {happens}",
            advice=f"write {each.near}",
            severity=None if each.fatal and each.used else "warning",
        )
