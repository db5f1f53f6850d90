"""The packages that launch files name: which are known, which are meant, and what they hold."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.facts.ros.node_roles import packages
from bringup_lint.graph.memo import memo
from bringup_lint.pattern import regex
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package

PUBLIC = ("nav2_", "ros2_", "ros_", "rclcpp_", "tf2_", "launch_", "image_", "joint_", "moveit_", "rviz", "controller_")
"""How packages of ROS itself begin."""
_DIGIT = regex(r"\d")
_CODE = (".py", *CPP)
_MOST_CODE = 200_000
"""Characters of a source that are looked at."""
_SHARE = regex(
    r"package_?share|share_?directory|ament_index|getSharePath",
    re.I,
    "package_share packageshare share_directory sharedirectory ament_index getsharepath",
)
"""How a source asks for the folder of a package."""


def is_known_package(name: str) -> bool:
    """Whether a package is a public one that the tables know, so that its name is no misspelling."""
    return name in packages() or name.startswith(PUBLIC)


@memo
def package_like(launch: Launch, package: str) -> Package | None:
    """The package of the workspace that is meant by a name which nobody has."""
    known = launch.workspace.packages
    is_known = package in known or package in launch.workspace.ambiguous or is_known_package(package)
    near = nearest(package, sorted(known)) if not is_known and len(package) > 5 else []
    names = [other for other in near if _DIGIT.sub("", other) != _DIGIT.sub("", package)]
    return known[names[0]] if names else None


def comes_with(launch: Launch, owner: Package, name: str) -> bool:
    """Whether a package is there when another one's dependencies are, as far as this can be told: through packages of
    the workspace, or because a package of the same family is depended on."""
    family = name.partition("_")[0]
    return any(
        depend == name or (depend.partition("_")[0] == family and depend not in launch.workspace.packages)
        for depend in launch.workspace.required(owner)
    )


def yaml_names(launch: Launch, package: Package) -> list[str]:
    """The names of the YAML files that a package installs, or of all that it holds."""
    names = set()
    for name in launch.files.tree.names_below(package.folder, depth=8):
        if name.endswith((".yaml", ".yml")):
            names.add(name)
        if len(names) > 1000:
            break
    return sorted(names)


def path_of(launch: Launch, name: str, package: Package) -> str:
    """Where a package has a file of this name; the name itself when that is not known."""
    paths = (os.path.relpath(path, package.folder) for path in launch.files.tree.named(name))
    return next((path for path in sorted(paths) if not path.startswith("..")), name)


@memo
def code_of(launch: Launch, folder: str) -> str:
    """The sources of the nodes below a folder."""
    paths = (path for path in launch.files.tree.walked_below(folder) if path.endswith(_CODE))
    return "\n".join(launch.files.tree.head(path, _MOST_CODE) for path in paths)


@memo
def asks_for_share(launch: Launch, folder: str) -> bool:
    """Whether a source of a node below a folder asks for the folder of a package."""
    return _SHARE.search(code_of(launch, folder)) is not None
