"""Which distribution of ROS an image certainly holds: that of an official image, or the one that its steps install."""

from __future__ import annotations

import re

from bringup_lint.facts.ros.distros import distros_since
from bringup_lint.graph.containers.base_images import ros_distro
from bringup_lint.graph.containers.base_images import ubuntu_codename
from bringup_lint.graph.containers.base_images import variant_of
from bringup_lint.model.dockerfile import Stage
from bringup_lint.parsers.dockerfile_variables import variables
from bringup_lint.pattern import regex

_NAMED = regex(
    r"\b(?:ros2?\b|ros[-_:]|colcon\b|rosdep\b|ament|rmw_|rclpy|rclcpp|xrce|fastdds|cyclonedds|mavlink)",
    re.I,
    "ros colcon ament rmw_ rcl xrce dds mavlink",
)
_INSTALLED = regex(r"\binstall\b[^\n;&]*?\bros-(?P<distro>[a-z]+|\$\{?ROS_DISTRO\}?)-[a-z]")


def holds_ros(stage: Stage) -> bool:
    """Whether an image begins with one of ROS, or names ROS or what robots talk with beside it in a step."""
    if ros_distro(stage.origin):
        return True
    return any(_NAMED.search(each.value) for one in stage.chain for each in one.instructions)


def distro_of(stage: Stage) -> str:
    """Humble or a later distribution; empty where it is not known."""
    origin = stage.origin
    if variant_of(origin) or ros_distro(origin) or not ubuntu_codename(origin):
        return variant_of(origin)
    values = {name: value for one in reversed(list(stage.chain)) for name, value in variables(one).items()}
    steps = (str(each.value) for one in stage.chain for each in one.all("RUN"))
    written = {match["distro"].strip("${}") for step in steps for match in _INSTALLED.finditer(step)}
    names = {values.get(name, name) for name in written}
    return next(iter(names)) if len(names) == 1 and names <= set(distros_since("humble")) else ""
