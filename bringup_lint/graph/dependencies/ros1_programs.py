"""Programs of ROS 1 that a package of ROS 2 installs."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.package import Install
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Package

_ROSPY = regex(r"(?:\A|\n)(?:import (?:[\w.]{1,60}(?: as \w{1,60})?, ?){0,8}|from )rospy(?![\w-])", hints="rospy")
"""Not inside a ``try``, which is indented."""
_TEXT = regex(r"(\"{3}|'{3}).*?(?:\1|\Z)", re.S)
_BOTH = ("rospy", "roscpp", "catkin", "ros1_bridge", "ROS_VERSION")
_OWN = regex(r"(?:^|/)rospy(?:/__init__)?\.py$", hints="rospy")
"""A module of that name for ROS 2, or ROS 1 in the same workspace."""
_READ = 16_384
"""Bytes in which a program imports what it needs."""


def ros1_programs(tree: Tree, package: Package) -> Iterator[Install]:
    """The installed Python programs that import rospy; none in a package that is built for both."""
    if not package.manifest.build_type.startswith("ament"):
        return
    texts = [package.manifest.source.text, *(build.source.text for build in package.builds)]
    if any(word in text for text in texts for word in _BOTH) or any(tree.like(_OWN)):
        return
    for build in package.builds:
        folder = os.path.dirname(build.source.absolute)
        for install in build.installs:
            if install.destination.startswith("lib/") and not install.tree:
                path = os.path.normpath(os.path.join(folder, install.source))
                if tree.exists(path) and _ROSPY.search(_TEXT.sub("", tree.head(path, _READ))):
                    yield install
