"""A script of a ROS 2 robot runs a command of ROS 1.

## What it finds
`roslaunch`, `rosrun`, `roscore`, `rostopic`, `rosparam`, `rosservice`, `rosnode` and `catkin_make` in scripts of a
tree all of whose packages are built with ament, in which no file names a distribution of ROS 1 or its libraries; in
any tree, in scripts and units that set up ROS 2 themselves and do not speak of ROS 1. Silent
where the message is thrown away or the failure is handled, and where the script has an alias or a function of this
name. A warning where nothing else of the tree names any of the scripts, and info where none of these sets up ROS 2
or names a package of the tree either: they are left from ROS 1.

## Why it matters on a robot
No distribution of ROS 2 has these commands: "command not found". What the script was to start does not run.

## Bad
```sh
source /opt/ros/humble/setup.bash
roslaunch rover_bringup rover.launch
```

## Good
```sh
source /opt/ros/humble/setup.bash
ros2 launch rover_bringup rover.launch.py
```

## When to ignore it
When the computer also has ROS 1, for a bridge.

## References
- https://docs.ros.org/en/jazzy/How-To-Guides/Migrating-from-ROS1.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import distros_since
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

INSTEAD = {
    "roslaunch": "ros2 launch",
    "rosrun": "ros2 run",
    "rostopic": "ros2 topic",
    "rosservice": "ros2 service",
    "rosparam": "ros2 param",
    "rosnode": "ros2 node",
    "rosbag": "ros2 bag",
    "catkin_make": "colcon build",
}
COMMANDS = (*INSTEAD, "roscore", "rosmaster")
OF_ROS1 = regex(
    r"\b(?:noetic|melodic|kinetic|indigo|ros1_bridge|ros1|roscpp|rospy|ROS_MASTER_URI|catkin_package|catkin_init_workspace)\b"
)


OF_ROS2 = regex(rf"/opt/ros/(?:{'|'.join(distros_since('foxy'))})\b|\bRMW_IMPLEMENTATION\b|\bCYCLONEDDS_URI\b")


@rule("error", symptoms=["roslaunch: command not found", "rosrun: command not found", "catkin_make: command not found"])
def ros1_command(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("ros", "catkin_make"):
        return
    found: dict[tuple[Source, str], Run] = {}
    for source, run in robot.scripts.run(*COMMANDS):
        if not run.command.hides_errors and run.command.ends != "||" and not _defines(source, run.name):
            found.setdefault((source, run.name), run)
    if found and not _is_ros2_only(robot):
        found = {key: run for key, run in found.items() if _sets_up_ros2(key[0])}
    if found:
        first, *others = found.values()
        yield finding(
            first.words[0],
            f"ROS 2 has no {first.name}: the command is not found, and this script does not do what it is for",
            advice=_advice(first.name),
            related=[note(other.words[0], f"{other.name} is not found either") for other in others[:20]],
            severity=_severity(robot, found),
        )
    yield from _in_units(robot)


def _severity(robot: Robot, found: dict[tuple[Source, str], Run]) -> str | None:
    if any(robot.scripts.is_named(source) for source, _ in found):
        return None
    is_own = any(_sets_up_ros2(source) or _is_for_tree(robot, run) for (source, _), run in found.items())
    return "warning" if is_own else "info"


def _is_for_tree(robot: Robot, run: Run) -> bool:
    """Whether a command builds the workspace, or names a package of it."""
    package = next((word for word in run.words[1:] if not word.startswith("-")), "")
    return run.name == "catkin_make" or package in robot.launch.workspace.packages


def _in_units(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("ros"):
        for process in robot.units.processes(unit):
            for step in process.steps:
                words = unwrapped(step.command.words)
                name = program_name(words[0]) if words else ""
                if name in COMMANDS and step.script is None and _sets_up_ros2(words[0].span.source):
                    yield finding(
                        words[0],
                        f"ROS 2 has no {name}: {unit.name} fails with status 127",
                        advice=_advice(name),
                    )


def _advice(name: str) -> str:
    instead = INSTEAD.get(name)
    return f"write {instead}" if instead else "remove it: ROS 2 has no master"


def _sets_up_ros2(source: Source) -> bool:
    """Whether a file takes the setup file of a distribution of ROS 2, or chooses its middleware, and never speaks of
    ROS 1."""
    return source.says(OF_ROS2) and not source.says(OF_ROS1)


def _defines(source: Source, name: str) -> bool:
    name = re.escape(name)
    return re.search(rf"\balias[ \t]+{name}=|^[ \t]*(?:function[ \t]+)?{name}[ \t]*\(\)", source.text, re.M) is not None


def _is_ros2_only(robot: Robot) -> bool:
    """Whether the packages of the tree are all for ROS 2, and nothing speaks of ROS 1."""
    types = {package.manifest.build_type for package in robot.launch.workspace.packages.values()}
    return bool(types) and all(each.startswith("ament") for each in types) and not robot.mentions(OF_ROS1)
