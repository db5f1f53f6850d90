"""What follows from the needs that a package does not declare: the worst of them decides."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.needed import base
from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.graph.dependencies.needs import Need
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
_SEVERAL = 3


class Effect(Enum):
    BUILD = "a clean build stops"
    ROBOT = "a fresh robot lacks a public package"
    APART = "a command builds the package without another one"
    RELEASE = "the Debian package comes without another one"
    EMPTY = "nothing that is needed at run time is declared"
    MOST = "most of what launch files start is not declared"
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
    undeclared = dependencies.undeclared(package)
    needs = [each for each in undeclared if not _PLACEHOLDER.search(each.name) and not launch.meant(each.name)]
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
    is_empty = not any(tag in AT_RUN_TIME for tag, _ in package.manifest.depends)
    if is_empty and len(of_robots(started)) >= _SEVERAL:
        return Undeclared(Effect.EMPTY, started, [], started)
    missed = [need for need in of_robots(started) if need.always and _is_missed(launch, package, need)]
    if len(missed) >= max(_SEVERAL, len(brought_up(dependencies, package)) // 2 + 1):
        return Undeclared(Effect.MOST, missed, [], started)
    return Undeclared(Effect.HARMLESS, started, [], started) if started else None


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


def _is_started(launch: Launch, package: Package, need: Need) -> bool:
    """Whether a launch file needs a package, and nothing that is declared has a name like it."""
    return need.use in ("node", "include") and not launch.comes_with(package, str(need.name))
