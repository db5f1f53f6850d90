"""C++ sources of ROS 2 nodes, with rclcpp or with rclc on a microcontroller, and of the drivers beside them."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.endings import CPP

FIRMWARE = (*CPP, ".c", ".ino")

_NODES = (
    *("rclcpp", "RCLCPP_", "create_publisher", "create_subscription", "create_wall_timer"),
    *("/msg/", "::msg::", "/srv/", "/action/"),
)
"""Names of rclcpp and of interfaces, also where only a header of the package includes rclcpp."""


def _is_node(path: str, head: Head) -> bool:
    if not path.endswith(FIRMWARE):
        return False
    text = head()
    return "rclc/" in text or (path.endswith(CPP) and any(word in text for word in _NODES))


_DEVICES = (
    *("linux/can", "SIOCGIFINDEX", "termios.h", "linux/i2c-dev.h", "gpiod", "wiringPi", "pigpio", "hidapi", "libusb"),
    *("mutex", "ifaddrs.h", "asio.hpp", "asio/", "linux/videodev2.h", "LibSerial", "libserial/", "serial/serial.h"),
)
"""Headers and calls by which programs open buses, ports, pins, cameras and sockets, and share what they read between
threads."""


def _is_driver(path: str, head: Head) -> bool:
    return path.endswith(CPP) and not _is_node(path, head) and any(word in head() for word in _DEVICES)


KINDS = (Kind("cpp-node", _is_node), Kind("cpp-driver", _is_driver))
