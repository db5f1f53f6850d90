"""Python sources of ROS 2 nodes: files and scripts that import rclpy, and modules that make the endpoints of a node
which they are handed, or of a class that builds on one of another module."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_IMPORT = regex(
    r"^[ \t]*(?:import[ \t]+(?:[\w.]+[ \t]*,[ \t]*)*rclpy\b|from[ \t]+rclpy(?:\.[\w.]+)?[ \t]+import\b)", re.M
)
_SHEBANG = regex(r"#![^\n]*\bpython")
_MAKES = regex(r"\.create_subscription\(|\bself\.create_(?:publisher|timer)\(", hints=".create_")
_OTHER = regex(r"[._-]launch\.py$|/(?:setup|conftest)\.py$|/launch/(?:[^/]+/)*[^/]+\.py$")


def _is_node(path: str, head: Head) -> bool:
    path = f"/{path}"
    if path.endswith(".py"):
        if not _OTHER.search(path):
            return bool("rclpy" in head() and _IMPORT.search(head())) or bool(_MAKES.search(head()))
        return "/launch/" in path and _says_nothing_of_launch(head())
    if "." in path.rpartition("/")[2]:
        return False
    return bool(_SHEBANG.match(head())) and bool(_IMPORT.search(head()))


def _says_nothing_of_launch(text: str) -> bool:
    """Whether a file beside launch files is a node."""
    return bool(_IMPORT.search(text)) and "launch" not in text


KINDS = (Kind("python-node", _is_node),)
