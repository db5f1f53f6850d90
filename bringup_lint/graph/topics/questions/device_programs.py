"""What a launched program does for the robot, as far as its end leaves the robot without a device or its odometry."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.topics.sources.code import Code
    from bringup_lint.graph.topics.topics import Topics

_BY_HAND = ("joy", "joy_linux", "spacenav")
"""Input devices: without them a robot drives on by itself."""
_AGENT = regex(r"\bmicro[-_]ros[-_]agent\b|\bMicroXRCEAgent\b", hints="agent Agent")
_IS_NO_AGENT = regex(
    r"--restart|--detach|(?<![\w-])-[a-z]{0,3}d[a-z]{0,3}\b"
    r"|(?<![\w-])(?:echo|printf|p?kill|killall|p?grep|systemctl|service|sleep|stop|rm|build|pull|while|until|tmux|screen)\b"
)
"""Commands that only name the agent, or start it again by themselves."""
_OPENS = regex(
    r"\bserial\.(?:Serial|serial_for_url)\s{0,2}\(|\bSMBus\s{0,2}\(|\bcan\.(?:interface\.)?Bus\s{0,2}\("
    r"|^[ \t]*(?:from|import)[ \t]+(?:RPi\.GPIO|RPi|Jetson\.GPIO|gpiod|lgpio|pigpio|gpiozero|spidev)\b"
    r"|^[ \t]*#[ \t]*include[ \t]*[<\"](?:linux/(?:i2c-dev|can|can/raw|spi/spidev)|gpiod|wiringPi|pigpio"
    r"|serial/serial|libserial/\w{1,40}|boost/asio/serial_port)\.h(?:pp)?[>\"]"
    r"|\bcfset[io]?speed\s{0,2}\(",
    re.M,
    hints="serial SMBus can. RPi Jetson gpio spidev linux/ wiringPi cfset",
)
"""How programs in Python and C++ open ports, buses and pins."""
_ODOMETRY = "nav_msgs/msg/Odometry"
_MEASURED = frozenset(
    f"sensor_msgs/msg/{name}"
    for name in ("Image", "Imu", "JointState", "LaserScan", "MagneticField", "NavSatFix", "PointCloud2", "Range")
)
_COMMANDED = frozenset(
    ("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped", "ackermann_msgs/msg/AckermannDrive")
)


def device_role(topics: Topics, node: Started) -> str | None:
    """What the robot is without when the program ends: ``driver``, ``hardware``, ``microcontroller`` or ``odometry``.
    A program of the workspace has to open a device and publish what it measures, to take commands to move and open a
    device or publish the odometry, or only to publish that."""
    package, executable = literal_text(node.package), literal_text(node.executable)
    if package in _BY_HAND or executable == "spawner":
        return None
    role = topics.launch.role(node).role
    if role in ("driver", "hardware"):
        return role
    text = node.span.text
    if package == "micro_ros_agent" or (package is None and _AGENT.search(text) and not _IS_NO_AGENT.search(text)):
        return "microcontroller"
    code = topics.code(node) if package in topics.launch.workspace.packages else None
    return None if code is None else _own_role(code)


def _own_role(code: Code) -> str | None:
    published = {each.type for each in code.endpoints if each.role == "publisher"}
    taken = {each.type for each in code.endpoints if each.role == "subscription"}
    opens = code.source is not None and code.source.matches(_OPENS)
    if (opens and published & _MEASURED) or (taken & _COMMANDED and (opens or _ODOMETRY in published)):
        return "driver"
    return "odometry" if _ODOMETRY in published else None
