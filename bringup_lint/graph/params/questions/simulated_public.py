"""Public launch files that give their nodes the clock of a simulation unless they are told otherwise."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from itertools import takewhile
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.launch_arguments import taken
from bringup_lint.facts.ros.simulation import BY_DEFAULT
from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.facts.ros.simulation import is_simulator
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.workspace import Place
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.expansion import Included
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runners import Runners

_NAME = "use_sim_time"
_FILES = ("slam_params_file", "params_file")
_FALSE = regex(r"^[ \t]*use_sim_time[ \t]*:[ \t]*(false|no|off)\b", re.I | re.M, hints="use_sim_time")
_PLAYED = regex(r"--clock\b", hints="--clock")
"""Of ros2 bag play: it publishes the time of the recording."""
_PAGES = regex(r"(?i)\.(?:md|rst|txt)$")
_SIZE = 200_000


class OfPublic(NamedTuple):
    where: Span
    package: str
    file: str
    overruled: Span | None
    """Where a parameter file that is passed says that the clock is real."""


def simulated_by_public(launch: Launch, runners: Runners) -> Iterator[OfPublic]:
    """Where launch files and runners of the robot start such a file and leave the clock to it, in a tree without a
    simulation or with parameters that ask for the real clock."""
    found: dict[tuple[str, int], OfPublic] = {}
    for expansion in launch.entries:
        if not launch.simulated(expansion.entry) and not _is_passed(launch, runners, expansion.entry):
            for each in _of_includes(launch, expansion):
                found.setdefault((each.where.source.name, each.where.start), each)
    for each in _of_commands(runners):
        found[each.where.source.name, each.where.start] = each
    if found:
        simulates = _simulates(launch)
        yield from (each for each in found.values() if each.overruled is not None or not simulates)


def _is_passed(launch: Launch, runners: Runners, file: LaunchFile) -> bool:
    """Whether all commands that start a launch file pass the argument, which the files that it includes see, or a page
    says so."""
    if _NAME in runners.always_passed(file):
        return True
    name = file.source.basename
    pages = [text for text in launch.files.tree.pages(_PAGES, _SIZE) if name in text and _NAME in text]
    told = re.compile(rf"\b{re.escape(name)}\b[^\n]*\b{_NAME}:=") if pages else None
    return told is not None and any(map(told.search, pages))


def _of_includes(launch: Launch, expansion: Expansion) -> Iterator[OfPublic]:
    for include in expansion.includes:
        where = _by_default(include.file) if include.target is None and include.source.source.judged else None
        if where is None or include.action.open or _NAME in include.arguments or _NAME in include.known:
            continue
        if _may_be_set(expansion, include):
            continue
        passed = (include.values[name] for name in _FILES if name in include.values)
        overruled = next((false for value in passed if (false := _false(launch, value)) is not None), None)
        first = next((name.span for name, _ in include.action.arguments), include.action.span)
        yield OfPublic(first, where.package, os.path.basename(where.path), overruled)


def _by_default(file: Value) -> Place | None:
    where = place(file)
    if where is None or where.base != "share" or os.path.basename(where.path) not in BY_DEFAULT.get(where.package, ()):
        return None
    return where


def _may_be_set(expansion: Expansion, include: Included) -> bool:
    """Whether an include before it, of a file that is not in the tree, may set the argument."""
    before = takewhile(lambda other: other is not include, expansion.includes)
    return any(other.target is None and _takes_clock(other.file) for other in before)


def _takes_clock(file: Value) -> bool:
    where = place(file)
    known = taken(where.package, os.path.basename(where.path)) if where is not None and where.base == "share" else None
    return known is None or _NAME in known.arguments


def _false(launch: Launch, value: Value) -> Span | None:
    """Where a parameter file of the tree asks for the real clock."""
    found = launch.find(value)
    if found is None or found.file is None:
        return None
    sources = (source for source in launch.files.of_kind("params") if source.absolute == found.file)
    return next((source.span(*said.span(1)) for source in sources for said in _FALSE.finditer(source.text)), None)


def _of_commands(runners: Runners) -> Iterator[OfPublic]:
    for each in runners.launches:
        package, file = str(each.package), str(each.target)
        if file not in BY_DEFAULT.get(package, ()) or each.runner.purpose is not Purpose.ROBOT:
            continue
        if each.file is None and all(name != _NAME for name, _ in each.arguments):
            yield OfPublic(each.target.span, package, file, None)


def _simulates(launch: Launch) -> bool:
    """Whether a tree has something of a simulation: a file named so, a recording that is played with its clock, or a
    launch file that starts a simulator."""
    if any(is_simulation(source.name) for source in launch.files.sources) or launch.files.mentions(_PLAYED):
        return True
    return any(map(is_simulator, {package for file in launch.launch_files for package in _started(launch, file)}))


def _started(launch: Launch, file: LaunchFile) -> Iterator[str]:
    expansion = launch.expansion(file)
    for node in expansion.nodes:
        yield literal_text(node.package) or ""
    for include in expansion.includes:
        where = place(include.file)
        yield "" if where is None else where.package
