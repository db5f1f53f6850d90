"""Robot descriptions, in URDF or for xacro."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind


def _is_description(path: str, head: Head) -> bool:
    return path.endswith((".urdf", ".xacro")) and ("<robot" in head() or "ros2_control" in head())


KINDS = (Kind("urdf", _is_description),)
