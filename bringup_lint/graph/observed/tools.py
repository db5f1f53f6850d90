"""Nodes that come with tools and libraries, as long as no file names them."""

from __future__ import annotations

import re

from bringup_lint.pattern import regex

_TOOL = regex(
    r"""_.*                                   # hidden: ros2 daemon, ros2 topic, rqt's own
    | launch_ros_\d+ | rviz\d*(?:_\w+)? | rqt_\w+ | rosbag2_(?:recorder|player) | ros2cli\w* | rosapi\w*
    | plotjuggler\w*
    | transform_listener_impl_\w+ | \w+_rclcpp_node | interactive_marker_\w+ | \w*_private_\d+ | anonymous\w*
    | gazebo | moveit_\w+_\d+ | \w+_\d{4,}(?:_\d+)*  # the last: made unique by process ids and times
    """,
    re.VERBOSE,
)
_COMPANIONS = {
    "nav2_controller": ("local_costmap",),
    "nav2_planner": ("global_costmap",),
    "nav2_bt_navigator": ("navigate_to_pose", "navigate_through_poses"),
    "nav2_lifecycle_manager": ("lifecycle_manager",),
    "robot_localization": ("navsat_transform",),
}
"""Package -> how the bare names of further nodes begin that its programs bring along."""
OPEN_ENDED = frozenset(
    ("controller_manager", "foxglove_bridge", "gazebo_ros", "micro_ros_agent", "ros_gz_bridge", "rosbridge_server")
)
"""Packages whose programs bring along nodes with names of their own choice, such as controllers."""
PASSING = regex(
    r"(?:^|_)(?:spawn|spawner|unspawner|create|load|call|set|get|send|wait|check|verify|save|saver|dump|init|setup|configure|cli|once"
    r"|calibrate|test|echo|pub)(?:$|_|\.)"
)
"""Executables that do their work and end."""


_ON_SCREEN = regex(r"rviz\d*(?:_\w+)?|rqt_\w+|plotjuggler\w*|gazebo")


def is_on_screen(name: str) -> bool:
    """Whether a node is for somebody who looks, and may be closed."""
    return bool(_ON_SCREEN.fullmatch(name.rpartition("/")[2]))


def is_tool(name: str) -> bool:
    """Whether a fully qualified name is one that tools and libraries give their nodes."""
    return bool(_TOOL.fullmatch(name.rpartition("/")[2]))


def comes_with(name: str, known: str, package: str | None) -> bool:
    """Whether a running node is brought along by a known one: it lies below its name, or begins with it."""
    if name.startswith((f"{known}/", f"{known}_")):
        return True
    bare, namespace = name.rpartition("/")[2], name.split("/")[1:-1]
    starts = _COMPANIONS.get(package or "", ())
    return any(bare.startswith(start) or start in namespace for start in starts)
