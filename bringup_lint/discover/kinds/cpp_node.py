"""C++ sources of ROS 2 nodes: files that include or use rclcpp."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind

SUFFIXES = (".cpp", ".cc", ".cxx", ".hpp", ".hh", ".h")


def _is_node(path: str, head: Head) -> bool:
    return path.endswith(SUFFIXES) and "rclcpp" in head()


KINDS = (Kind("cpp-node", _is_node),)
