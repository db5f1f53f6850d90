"""What a package needs and leaves out of its package.xml, apart by whether what it declares brings it all the same."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.brought import brought_by
from bringup_lint.facts.ros.brought import is_known_to_bring
from bringup_lint.facts.ros.needed import COMMON
from bringup_lint.facts.ros.needed import base
from bringup_lint.graph.dependencies.needs import Need
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.dependencies.dependencies import Dependencies
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package

TOOLS = ("ament_", "rosidl_", "launch", "python3-pytest")
_METAPACKAGES = ("common_interfaces", "ros_core", "ros_base", "desktop", "desktop_full")
_COMMON = frozenset(
    "actionlib_msgs diagnostic_msgs geometry_msgs nav_msgs sensor_msgs sensor_msgs_py shape_msgs std_msgs std_srvs "
    "stereo_msgs trajectory_msgs visualization_msgs".split()
)
"""What the metapackages of messages bring (common_interfaces/package.xml; REP 2001)."""
_NAMED = ("share", "description")
"""What launch files and descriptions look up, whatever the node that they start."""
_UNLIKELY = 2
"""Packages that a dependency which no table knows would have to bring all."""
_TRIAL = regex(r"test|demo|example|debug|display|view|standalone|template|sim|gazebo")
"""Launch files that somebody starts to try something."""


class Omitted(NamedTuple):
    sure: list[Need]
    """Packages of ROS that nothing brings which the package declares."""
    others: list[Need]
    """Those that something brings or may bring, that no table knows, and modules and libraries that rosdep has a key
    for."""


def omitted(dependencies: Dependencies, launch: Launch, package: Package, needs: list[Need]) -> Omitted:
    """``needs``: what is not declared of the packages of ROS that are needed in any case."""
    declared = frozenset(map(str, launch.workspace.required(package)))
    brought = brought_by(declared)
    known = all(name in launch.workspace.packages or is_known_to_bring(name) for name in declared)
    sure: list[Need] = []
    likely: list[Need] = []
    others: list[Need] = []
    for need in needs:
        if dependencies.is_of_workspace(need):
            found = sure if dependencies.is_built_beside(need) else others
        elif str(need.name) in brought:
            found = others
        elif need.use in ("module", "library"):
            found = sure if known else likely
        elif need.fact is not None:
            found = sure
        elif need.use in _NAMED:
            found = sure if known else likely
        else:
            found = others
        found.append(need)
    (sure if len(likely) >= _UNLIKELY else others).extend(likely)
    return Omitted(sure, [*others, *_with_keys(dependencies, package, declared)])


def _with_keys(dependencies: Dependencies, package: Package, declared: frozenset[str]) -> Iterator[Need]:
    """The modules and libraries that rosdep has a key for, and that nothing of a like name brings."""
    for need in dependencies.undeclared(package):
        if need.use not in ("module", "library") or not need.always:
            continue
        fact, key = need.fact, COMMON.get(str(need.name), "")
        if fact is not None and fact.key and not any(map(fact.comes_with, declared)):
            yield need
        elif key and not any(name.replace("lib", "").startswith(key) for name in declared):
            yield need


def of_launch_files(needs: list[Need]) -> list[Need]:
    """Those that launch files name which are for more than a trial."""
    return [need for need in needs if _is_written(need) and not _TRIAL.search(need.name.span.source.basename)]


def _is_written(need: Need) -> bool:
    """Whether a name stands where it is used: the default of an argument is a choice."""
    return need.use == "program" or need.name.span.text.strip("'\"") == need.name


def of_sources(dependencies: Dependencies, launch: Launch, package: Package, needs: list[Need]) -> list[Need]:
    """The packages of ROS that installed modules import or CMake requires in any case, each once."""
    found: dict[str, Need] = {}
    brought = _COMMON if any(name in _METAPACKAGES for _, name in package.manifest.depends) else frozenset()
    for need in needs:
        if need.use == "module" and _is_loose(launch, package, need):
            continue
        is_asked = need.use in ("module", "library") and need.always and str(need.name) not in brought
        if is_asked and _is_of_ros(dependencies, launch, package, need):
            found.setdefault(str(need.name), need)
    return list(found.values())


def _is_loose(launch: Launch, package: Package, need: Need) -> bool:
    """Whether a file that imports something lies beside the modules that its package installs."""
    folder = posixpath.dirname(need.name.span.source.absolute)
    initial = posixpath.join(folder, "__init__.py")
    return package.manifest.build_type == "ament_python" and not launch.workspace.tree.exists(initial)


def _is_of_ros(dependencies: Dependencies, launch: Launch, package: Package, need: Need) -> bool:
    name, fact = str(need.name), need.fact
    if fact is not None and fact.is_package:
        return not any(map(fact.comes_with, launch.workspace.required(package)))
    return not name.startswith(TOOLS) and (
        name in base() or name.endswith("_msgs") or dependencies.is_of_workspace(need)
    )
