"""The distribution does not read this variable.

## What it finds
Variables that the robot's distribution does not read: discovery range and static peers before Iron, variables of
rmw_zenoh before Humble, `RCUTILS_CONSOLE_STDOUT_LINE_BUFFERED`, which nothing reads any more, and `ROS_IP`,
`ROS_HOSTNAME` and `ROS_MASTER_URI` of ROS 1 in a tree that holds nothing of ROS 1.

## Why it matters on a robot
The setting has no effect, and no message says so: discovery, for example, stays as wide as it was.

## Bad
```sh
ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST      (on Humble)
```

## Good
```sh
ROS_LOCALHOST_ONLY=1
```

## When to ignore it
When the same file also serves robots with a distribution that reads the variable.

## References
- rcl of each distribution
- https://docs.ros.org/en/rolling/Tutorials/Advanced/Improved-Dynamic-Discovery.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least

SINCE = {
    "ROS_AUTOMATIC_DISCOVERY_RANGE": ("iron", "use ROS_LOCALHOST_ONLY"),
    "ROS_STATIC_PEERS": ("iron", "name the peers in the DDS configuration"),
    "ZENOH_ROUTER_CONFIG_URI": ("humble", "rmw_zenoh exists from Humble on"),
    "ZENOH_SESSION_CONFIG_URI": ("humble", "rmw_zenoh exists from Humble on"),
    "ZENOH_CONFIG_OVERRIDE": ("humble", "rmw_zenoh exists from Humble on"),
}
GONE = {"RCUTILS_CONSOLE_STDOUT_LINE_BUFFERED": "use RCUTILS_LOGGING_BUFFERED_STREAM"}
OF_ROS1 = {
    "ROS_IP": "choose the interface in the DDS configuration",
    "ROS_HOSTNAME": "choose the interface in the DDS configuration",
    "ROS_MASTER_URI": "choose a ROS_DOMAIN_ID; ROS 2 has no master",
}
ROS1 = regex(
    r"/opt/ros/(?:noetic|melodic|kinetic|lunar|indigo)\b|\b(?:roscore|roslaunch|rosrun|rosmaster|rospy|roscpp|catkin)\b"
    r"|ros1|roslib|rosserial|rosgo|ros-(?:noetic|melodic|kinetic)-|ros:(?:noetic|melodic|kinetic)"
)


@rule("warning", silent="a distribution does not look at variables that it does not know")
def var_ignored_on_distro(robot: Robot) -> Iterator[Finding]:
    if robot.target.ros is None:
        return
    for setting in robot.ros.settings:
        if setting.name in OF_ROS1 and robot.is_ros and not robot.mentions(ROS1):
            yield finding(
                setting.value,
                f"{setting.name} is a variable of ROS 1: nothing of ROS 2 reads it",
                advice=OF_ROS1[setting.name],
            )
            continue
        since, instead = SINCE.get(setting.name, ("", GONE.get(setting.name, "")))
        if setting.name in GONE or (since and at_least(robot.target.ros, since) is False):
            yield finding(
                setting.value,
                f"{robot.target.ros} does not read {setting.name}: it has no effect",
                advice=instead,
            )
