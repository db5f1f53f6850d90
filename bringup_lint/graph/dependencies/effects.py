"""What follows from the needs that a package does not declare: the worst of them decides."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.needed import base
from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.graph.dependencies.dependencies import COMMENTED_OUT
from bringup_lint.graph.dependencies.needs import Need
from bringup_lint.graph.dependencies.omitted import TOOLS
from bringup_lint.graph.dependencies.omitted import of_launch_files
from bringup_lint.graph.dependencies.omitted import of_sources
from bringup_lint.graph.dependencies.omitted import omitted
from bringup_lint.graph.launch.packages import comes_with
from bringup_lint.graph.launch.packages import package_like
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.dependencies.dependencies import Dependencies
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package

AT_RUN_TIME = ("exec_depend", "run_depend", "depend")
_PLACEHOLDER = regex(r"^(?:your|my)_(?:package|pkg|robot|node)|package_name$")
_VIEWER = regex(r"^(?:rviz|rqt|plotjuggler)|_gui$")
"""Viewers and simulators, which no robot needs."""
_EXPLAINED = regex(r"<!--\s{0,20}\w[^<>]{0,300}<(?:exec_|run_)?depend\b", hints="<!--")
"""A dependency in a comment after words, which say why it and others are left out."""
_OF_LAUNCH_FILES = frozenset(("launch", "launch_ros", "ament_index_python"))
_STARTED = ("node", "include")
_NAMED = (*_STARTED, "share", "description")
"""What must be found, or a launch file or a description is not loaded."""
_SEVERAL = 3
_MANY = 5
"""Packages, whatever the share of those that are declared."""


class Effect(Enum):
    BUILD = "a clean build stops"
    ROBOT = "a fresh robot lacks a public package"
    APART = "a command builds the package without another one"
    RELEASE = "the Debian package comes without another one"
    EMPTY = "nothing that is needed at run time is declared"
    SEVERAL = "several packages that launch files start are not declared"
    SOURCES = "most packages of ROS that the sources need are not declared"
    SOME = "some packages that are needed are not declared"
    HARMLESS = "the packages are there all the same"


class Undeclared(NamedTuple):
    effect: Effect
    needs: list[Need]
    """Those with the effect."""
    others: list[Need]
    """Those that have a lesser one."""
    started: list[Need]
    """All packages that launch files start or include."""


def effect_of(dependencies: Dependencies, launch: Launch, package: Package) -> Undeclared | None:
    """None when nothing is to be said of the package."""
    needs = _judged(dependencies, launch, package)
    stopping = [need for need in needs if dependencies.stops_build(need)]
    lacking = [need for need in needs if dependencies.is_lacking(need)]
    apart = [need for need in needs if dependencies.left_out(need)]
    released = [need for need in needs if dependencies.is_released_without(need)]
    started = [need for need in needs if _is_started(launch, package, need)]
    if stopping:
        return Undeclared(Effect.BUILD, stopping, lacking, started)
    if lacking:
        return Undeclared(Effect.ROBOT, lacking, apart, started)
    if apart:
        return Undeclared(Effect.APART, apart, [], started)
    if released:
        return Undeclared(Effect.RELEASE, released, [], started)
    asked = [*started, *(need for need in needs if need.use == "module" and _is_known(dependencies, need))]
    missed = [need for need in of_robots(asked) if need.always and _is_missed(launch, package, need)]
    is_empty = _is_empty(package)
    if is_empty and (len(of_robots(started)) >= _SEVERAL or (missed and len(asked) >= _SEVERAL)):
        return Undeclared(Effect.EMPTY, [*missed, *(need for need in asked if need not in missed)], [], started)
    unbuilt = [need for need in missed if need in started]
    if len(unbuilt) >= min(_MANY, max(_SEVERAL, len(brought_up(dependencies, package)) // 2 + 1)):
        return Undeclared(Effect.SEVERAL, unbuilt, [], started)
    unknown = of_sources(dependencies, launch, package, needs)
    if len(unknown) >= max(_MANY, len(_declared(package)) + 1) and not _gives_a_reason(package):
        return Undeclared(Effect.SOURCES, unknown, [], started)
    some = _some(dependencies, launch, package, needs)
    return some or (Undeclared(Effect.HARMLESS, started, [], started) if started else None)


def rest_of(dependencies: Dependencies, launch: Launch, package: Package, said: Undeclared) -> Undeclared | None:
    """What else is not declared, where a worse effect of some needs is said already; None where there is nothing."""
    if said.effect not in (Effect.ROBOT, Effect.APART, Effect.RELEASE):
        return None
    names = {str(need.name) for need in (*said.needs, *said.others, *said.started)}
    needs = [need for need in _judged(dependencies, launch, package) if str(need.name) not in names]
    found = _some(dependencies, launch, package, needs)
    return found if found is not None and found.needs else None


def _judged(dependencies: Dependencies, launch: Launch, package: Package) -> list[Need]:
    undeclared = dependencies.undeclared(package)
    return [each for each in undeclared if not _PLACEHOLDER.search(each.name) and not package_like(launch, each.name)]


def _some(dependencies: Dependencies, launch: Launch, package: Package, needs: list[Need]) -> Undeclared | None:
    """Some packages that are needed, and not declared; not those whose dependency is commented out."""
    if _EXPLAINED.search(package.manifest.source.text) is not None:
        return None
    reasons = set(COMMENTED_OUT.findall(package.manifest.source.text))
    asked = [need for need in needs if str(need.name) not in reasons]
    named = [need for need in of_robots(needs) if need.always and need.use in _NAMED]
    programs = [need for need in needs if need.use == "program" and need.fact is not None and need.always]
    ran = [need for need in programs if _is_missed(launch, package, need)]
    unbuilt = [need for need in named if _is_missed(launch, package, need) and not _is_brought(launch, package, need)]
    unknown = of_sources(dependencies, launch, package, asked)
    left = omitted(dependencies, launch, package, [*unknown, *of_launch_files([*unbuilt, *ran])])
    started = [need for need in needs if _is_started(launch, package, need)]
    return Undeclared(Effect.SOME, left.sure, left.others, started) if left.sure or left.others else None


def _declared(package: Package) -> list[str]:
    """What a package declares besides tools of the build and of tests."""
    return [name for _, name in package.manifest.depends if not name.startswith(TOOLS)]


def _is_empty(package: Package) -> bool:
    """Whether a package declares nothing that it needs at run time, not even in a comment, which says why."""
    declares = any(tag in AT_RUN_TIME for tag, _ in package.manifest.depends)
    return not declares and not _gives_a_reason(package)


def _gives_a_reason(package: Package) -> bool:
    """Whether a dependency is in a comment, which says why."""
    return COMMENTED_OUT.search(package.manifest.source.text) is not None


def _is_known(dependencies: Dependencies, need: Need) -> bool:
    """Whether a package of ROS is imported: of ros-base, of the tables, of messages or of the workspace. What every
    launch file imports does not count."""
    name = str(need.name)
    if name in _OF_LAUNCH_FILES:
        return False
    return need.fact is not None or name in base() or name.endswith("_msgs") or dependencies.is_of_workspace(need)


def brought_up(dependencies: Dependencies, package: Package) -> list[str]:
    """The other packages of which launch files always start something, without ros-base, viewers and simulators."""
    return [name for name in dependencies.started(package) if name not in base() and not _is_aside(name)]


def of_robots(needs: list[Need]) -> list[Need]:
    """Without viewers and simulators."""
    return [need for need in needs if not _is_aside(str(need.name))]


def _is_aside(package: str) -> bool:
    """Whether a package is a viewer or a simulator."""
    return _VIEWER.search(package) is not None or is_simulation(package)


def _is_missed(launch: Launch, package: Package, need: Need) -> bool:
    """Whether ros-base and what is declared do not bring a package, which does not depend on the one that starts it."""
    starts = launch.workspace.packages.get(str(need.name))
    is_circular = starts is not None and package.name in launch.workspace.required(starts)
    comes = need.fact is not None and any(map(need.fact.comes_with, launch.workspace.required(package)))
    return need.name not in base() and not is_circular and not comes


def _is_brought(launch: Launch, package: Package, need: Need) -> bool:
    """Whether something that is declared has a name like what is started."""
    return need.use in _STARTED and not _is_started(launch, package, need)


def _is_started(launch: Launch, package: Package, need: Need) -> bool:
    """Whether a launch file needs a package, and nothing that is declared has a name like it."""
    return need.use in _STARTED and not comes_with(launch, package, str(need.name))
