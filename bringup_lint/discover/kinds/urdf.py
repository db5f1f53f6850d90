"""Robot descriptions, in URDF or for xacro."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind

_MARKS = ("<robot", "ros2_control", "<link", "http://www.ros.org/wiki/xacro", "http://ros.org/wiki/xacro")


def _is_description(path: str, head: Head) -> bool:
    return path.endswith((".urdf", ".xacro")) and any(mark in head() for mark in _MARKS)


KINDS = (Kind("urdf", _is_description),)
