"""A robot description names a plugin of Gazebo that ROS 2 does not have.

## What it finds
`libgazebo_ros_control.so`, `libgazebo_ros_laser.so`, `libgazebo_ros_imu.so`, `libgazebo_ros_range.so` and so on
in the descriptions of a tree whose launch files start Gazebo Classic with `gazebo_ros`. Silent for descriptions that no
launch file loads, for packages of ROS 1, for plugins under `xacro:if`, and in macros. One finding for all, which is an
info where the package.xml calls what it has for Gazebo legacy or optional.

## Why it matters on a robot
Gazebo says that it cannot load the plugin and goes on without it. In the simulation no controller moves the joints, or
the sensor publishes nothing: what is to be tried there before the robot does it cannot be tried.

## Bad
```xml
<plugin name="control" filename="libgazebo_ros_control.so"/>
```

## Good
```xml
<plugin name="control" filename="libgazebo_ros2_control.so">
  <parameters>$(find rover)/config/controllers.yaml</parameters>
</plugin>
```

## When to ignore it
When the tree builds a plugin of this name.

## References
- https://github.com/ros-simulation/gazebo_ros_pkgs/wiki, "ROS 2 Migration"
- https://control.ros.org/humble/doc/gazebo_ros2_control/doc/index.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

LEGACY = regex(r"\b(?:legacy|optional|deprecated|obsolete)\b[^.\n<>]{0,60}\bgazebo\b", re.I, "gazebo")
CONTROL = ("libgazebo_ros_control.so", "libgazebo_ros_skid_steer_drive.so")


@rule(
    "warning",
    symptoms=["Failed to load plugin libgazebo_ros_control.so", "Failed to load plugin libgazebo_ros_laser.so"],
)
def simulator_plugin_of_ros1(robot: Robot) -> Iterator[Finding]:
    for first, *others in robot.plugins.gone_simulator_plugins:
        lost = "no controller moves the joints" if first.name in CONTROL else "the sensor publishes nothing"
        yield finding(
            first.name,
            f"{first.name} is a plugin of ROS 1, which ROS 2 does not have: in the simulation {lost}",
            advice=f"use {first.instead}, whose parameters have other names",
            related=[note(each.name, f"this one is gone, too: use {each.instead}") for each in others[:9]],
            severity="info" if is_left_behind(robot, first.name) else None,
        )


def is_left_behind(robot: Robot, name: Located) -> bool:
    """Whether the package of a description says that its simulation is one of the past, or nothing that it needs."""
    owner = robot.launch.workspace.owner(name.span.source)
    return owner is not None and owner.manifest.source.says(LEGACY)
