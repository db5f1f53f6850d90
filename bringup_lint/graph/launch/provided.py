"""Packages that anything of a tree brings: a script, an image, a list of repositories, the documentation."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.discover.tree import Tree
from bringup_lint.pattern import regex

_TELLING = regex(
    r"(?:^|/)(?:[^/]*dockerfile[^/]*|\.gitmodules|[Mm]akefile|[Jj]ustfile|[^/]+\.(?:sh|bash|zsh|md|rst|txt|repos|rosinstall"
    r"|ya?ml|j2|toml|nix|bb|bbappend|cfg|json|ipynb|html?))$",
    re.I,
)
_MOST = 200_000
"""Characters of a file that are looked at."""
_WORD = regex(r"[a-z][a-z0-9_-]{1,100}")
_PREFIX = regex(r"^ros_[a-z]{1,20}_")
_PARAMETERS = "ros__parameters"

BASE = frozenset(
    "robot_state_publisher tf2_ros rclcpp_components rosbag2_transport launch_ros joint_state_publisher "
    "joint_state_publisher_gui rviz2".split()
)
"""Nodes that come with ros-base, or with what every model and simulation depends on."""
DESKTOP = frozenset("depthimage_to_laserscan joy teleop_twist_joy teleop_twist_keyboard image_tools".split())
"""Nodes that only the variant desktop brings. Source: REP 2001."""


def words(tree: Tree) -> frozenset[str]:
    """The words of all files that may say what to install, with underscores, without the prefix of Debian packages."""
    return frozenset(word for text in _texts(tree) for word in _words(text))


def _texts(tree: Tree) -> Iterator[str]:
    for path in tree.paths:
        if _TELLING.search(path):
            text = tree.head(path, _MOST)
            if _PARAMETERS not in text:
                yield text


def _words(text: str) -> Iterator[str]:
    for match in _WORD.finditer(text.lower()):
        word = match[0].replace("-", "_")
        yield word
        yield _PREFIX.sub("", word)
