"""C++ sources of ROS 2 nodes, with rclcpp or with rclc on a microcontroller, and of the drivers beside them."""

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


_DEVICES = ("linux/can", "SIOCGIFINDEX", "termios.h")
"""Headers and calls by which Linux programs open a CAN bus or a serial port."""


def _is_driver(path: str, head: Head) -> bool:
    return path.endswith(SUFFIXES) and not _is_node(path, head) and any(word in head() for word in _DEVICES)


KINDS = (Kind("cpp-node", _is_node), Kind("cpp-driver", _is_driver))
