"""Programs of ROS 1 that a package of ROS 2 installs."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.package import Install
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Package

_ROSPY = regex(r"(?:\A|\n)(?:import rospy\b|from rospy\b)", hints="rospy")
"""Not inside a ``try``, which is indented."""
_BOTH = ("rospy", "catkin")
_READ = 16_384
"""Bytes in which a program imports what it needs."""


def ros1_programs(tree: Tree, package: Package) -> Iterator[Install]:
    """The installed Python programs that import rospy; none in a package that is built for both."""
    if not package.manifest.build_type.startswith("ament"):
        return
    texts = [package.manifest.source.text, *(build.source.text for build in package.builds)]
    if any(word in text for text in texts for word in _BOTH):
        return
    for build in package.builds:
        folder = os.path.dirname(build.source.absolute)
        for install in build.installs:
            if install.destination.startswith("lib/") and not install.tree:
                path = os.path.normpath(os.path.join(folder, install.source))
                if tree.exists(path) and _ROSPY.search(tree.head(path, _READ)):
                    yield install
