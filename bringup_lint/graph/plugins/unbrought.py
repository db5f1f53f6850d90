"""Packages of plugins of which nothing in a tree says how they get onto the robot."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Workspace

_TELLING = regex(
    r"(?:dockerfile|containerfile)[^/]*$|(?:^|/)\.gitmodules$"
    r"|\.(?:sh|bash|py|xml|xacro|urdf|cpp|hpp|h|cc|txt|md|rst|repos|rosinstall|ya?ml|j2|toml|json|nix|ipynb|html?)$",
    re.I,
)
"""Files that may build, fetch, install or explain a package."""
_FETCHING = regex(r"\.(?:repos|rosinstall|gitmodules)$")
_PARAMETERS = "ros__parameters"
_MOST = 200_000
"""Characters of a file that are looked at."""
_FAMILY = 4
"""Letters of the first word of a name from which on it is more than an abbreviation."""
_COMMON = ("nav2", "robot", "ros2", "rviz", "moveit")
"""First words that say nothing of where a package comes from."""


class Unbrought:
    """What is asked of the texts of a tree, each word once."""

    def __init__(self, tree: Tree, workspace: Workspace) -> None:
        self._tree = tree
        self._workspace = workspace
        self._answers: dict[str, bool] = {}

    def is_unbrought(self, package: str) -> bool:
        """Whether no file but parameter files names a package, and nothing that is fetched or declared a relative."""
        if package not in self._answers:
            self._answers[package] = not is_simulation(package) and not self._is_told(package)
        return self._answers[package]

    def _is_told(self, package: str) -> bool:
        family = package.partition("_")[0]
        is_known = len(family) >= _FAMILY and family not in _COMMON
        if is_known and any(family in name for name in self._declared()):
            return True
        for path in self._tree.like(_TELLING):
            text = self._tree.head(path, _MOST)
            if package in text or package.replace("_", "-") in text:
                if _PARAMETERS not in text:
                    return True
            elif is_known and family in text and _FETCHING.search(path):
                return True
        return False

    def _declared(self) -> frozenset[str]:
        """What the packages of the tree need of others."""
        workspace = self._workspace
        depends = (str(name) for package in workspace.packages.values() for _, name in package.manifest.depends)
        return frozenset(depends) - workspace.packages.keys()
