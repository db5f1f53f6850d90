"""A container selects a middleware that its image does not contain.

## What it finds
The `RMW_IMPLEMENTATION` of a Dockerfile or compose service names a middleware other than Fast DDS, the image is an
official one (`ros:`, `osrf/ros:`) or one of Ubuntu, CUDA or Jetson on which the steps install ROS, and nothing brings
the package: no step names it, and with `rosdep install` no package.xml of the tree does.

Silent where something unseen may bring it: a list of packages, a script that is not in the tree, a program that is
piped into a shell, packages of ROS from another image (a workspace that another stage builds from the tree is known),
rosdep over repositories that are cloned, volumes for a workspace that is not in the tree, and robots whose packages
need a middleware of their own, such as TurtleBot 4.

## Why it matters on a robot
Every ROS process of the container exits at start: the library librmw_..._cpp.so cannot be loaded.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
ENV RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
RUN apt-get update && apt-get install -y ros-jazzy-rmw-cyclonedds-cpp
ENV RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
```

## When to ignore it
When the workspace that is mounted into the container contains the middleware.

## References
- REP 2001: the variants ros_core, ros_base, perception and desktop
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.environment import missing_middleware


@rule(
    "warning",
    symptoms=[
        "failed to load shared library",
        "Error getting RMW implementation identifier",
        "failed to load any RMW implementations",
    ],
)
def rmw_package_missing(robot: Robot) -> Iterator[Finding]:
    if not robot.of_kind("compose", "dockerfile"):
        return
    for each in missing_middleware(robot.compose, robot.ros.processes):
        yield finding(
            each.variable.value,
            f"The image does not contain {each.variable.text}: every ROS process of the container exits at start",
            advice=f"install {each.package}",
            related=[note(each.image, "nothing adds the package to this image")],
        )
