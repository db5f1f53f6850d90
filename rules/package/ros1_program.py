"""A package of ROS 2 installs a program of ROS 1.

## What it finds
Python programs that CMakeLists.txt installs below `lib/` and that import `rospy`, in packages that are built with
ament. Silent in packages for both, whose package.xml or CMakeLists.txt mentions `rospy`, `roscpp`, `catkin`,
`ros1_bridge` or `ROS_VERSION`, and where the tree has a module `rospy` of its own.

## Why it matters on a robot
No distribution of ROS 2 has rospy. `ros2 run` finds the program, and it ends with "No module named 'rospy'".

## Bad
```cmake
install(PROGRAMS scripts/calibrate.py DESTINATION lib/${PROJECT_NAME})  # import rospy
```

## Good
```python
import rclpy
```

## When to ignore it
When the robot has a ROS 1 beside, whose modules are in the PYTHONPATH of the program.

## References
- https://docs.ros.org/en/jazzy/How-To-Guides/Migrating-from-ROS1/Migrating-Python-Packages.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["ModuleNotFoundError: No module named 'rospy'"])
def ros1_program(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        found = list(robot.dependencies.ros1_programs(package)) if robot.dependencies.judged(package) else []
        if found:
            first, *others = found
            yield finding(
                first.where,
                f"{first.source} imports rospy, which ROS 2 does not have: the program ends at its start",
                advice="port it to rclpy, or remove it from the installation",
                related=[note(other.where, f"{other.source} imports rospy, too") for other in others],
            )
