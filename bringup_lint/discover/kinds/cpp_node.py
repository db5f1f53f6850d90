"""C++ sources of ROS 2 nodes: files that include or use rclcpp, or rclc on a microcontroller."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind

SUFFIXES = (".cpp", ".cc", ".cxx", ".hpp", ".hh", ".h")
FIRMWARE = (*SUFFIXES, ".c", ".ino")


def _is_node(path: str, head: Head) -> bool:
    if not path.endswith(FIRMWARE):
        return False
    text = head()
    return "rclc/" in text or (path.endswith(SUFFIXES) and "rclcpp" in text)


KINDS = (Kind("cpp-node", _is_node),)
