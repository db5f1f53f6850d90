"""The names of public packages that any table knows."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import table
from bringup_lint.facts.ros.brought import brought_packages
from bringup_lint.facts.ros.public_programs import ROS1
from bringup_lint.spelling import Neighbours

_TABLES = ("base", "carried", "launch_arguments", "lifecycle_nodes", "node_parameters", "parameter_free")
_ALIKE = frozenset(
    "ament_cmake_test gazebo_ros_control led_msgs mav_msgs nav2d_msgs rclc_lifecycle roslaunch rosbot_localization "
    "rosnode rosparam rosservice rostopic rslidar_driver rslidar_msg rslidar_msgs tensor_msgs".split()
)
"""Packages that rosdistro has, and that no table needs: they are called nearly as one that a table has. Derived from
the distribution files of all releases, and of ROS 1."""


@cache
def released() -> frozenset[str]:
    """All of them, those included that ROS 1 alone had."""
    names = {row["package"] for name in _TABLES for row in table(f"ros/{name}") if "*" not in row["package"]}
    names |= {row["name"] for row in table("ros/needed") if row["use"] == "package" and "*" not in row["name"]}
    names |= {row["package"] for row in table("ros/public_programs")}
    return frozenset(names) | brought_packages() | _ALIKE


@cache
def current() -> tuple[str, ...]:
    """Those that ROS 2 has, for which a misspelt name may stand, in order."""
    gone = {row["package"] for row in table("ros/public_programs") if row["last"] == ROS1}
    return tuple(sorted(released() - gone - _ALIKE))


@cache
def near_current() -> Neighbours:
    """The same, to look up what is misspelt."""
    return Neighbours(current())
