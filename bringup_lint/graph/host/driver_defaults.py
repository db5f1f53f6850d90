"""Device paths that the launch file of a driver gives only as its default, for others to replace."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.facts.ros import node_roles
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import literal

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.launch import LaunchFile
    from bringup_lint.source import Source

ALTERNATIVES = 3
"""Launch files of one package that start its own node, from which they are one for each model of a device."""


def is_driver_launch(source: Source, launch: Launch) -> bool:
    """Whether a launch file is a driver's own for its own node, and nothing outside of its package names it.

    A driver is a package that the table of roles knows, or one with a launch file for each of several models.
    """
    file, package = launch.of_source(source), launch.workspace.owner(source)
    if file is None or package is None or len(launch.workspace.packages) < 2 or not _starts(file, package):
        return False
    if any(_is_named(launch, other, source) for other in launch.workspace.packages.values() if other is not package):
        return False
    own = [other for other in launch.files_of(package) if _starts(other, package)]
    return node_roles.is_driver(package.name) or len(own) >= ALTERNATIVES


def _starts(file: LaunchFile, package: Package) -> bool:
    nodes = (action for action in walk_actions(file.actions) if isinstance(action, Node))
    return any(node.package is not None and literal(node.package) == package.name for node in nodes)


def _is_named(launch: Launch, package: Package, source: Source) -> bool:
    return any(source.basename in file.source.text for file in launch.files_of(package))
