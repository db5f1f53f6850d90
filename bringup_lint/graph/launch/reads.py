"""Which files read a launch configuration, and who starts a file without it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import kept
from bringup_lint.graph.purpose import Purpose
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import walk

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.expansion import Included
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.model.launch import LaunchFile
    from bringup_lint.source import Span


def reads_unseen(launch: Launch, files: Iterable[LaunchFile]) -> bool:
    """Whether files may read launch configurations by names that are not in them: by computed names, or in parameter
    files with substitutions."""
    unseen = _unseen(launch)
    return any(id(file) in unseen for file in files)


@kept
def _unseen(launch: Launch) -> frozenset[int]:
    return frozenset(id(file) for file in launch.launch_files if file.reads_all or _substitutes(file))


def _substitutes(file: LaunchFile) -> bool:
    for action in walk_actions(file.actions):
        for source in getattr(action, "parameters", ()):
            if any(isinstance(each, ParameterFile) and each.allow_substs is not None for each in walk(source)):
                return True
    return False


def read_in(launch: Launch, files: Iterable[LaunchFile]) -> set[str]:
    """The launch configurations that files read."""
    reads = _reads(launch)
    return set().union(*(reads[id(file)] for file in files))


@kept
def _reads(launch: Launch) -> dict[int, frozenset[str]]:
    return {id(file): frozenset(str(argument.name) for argument in file.reads) for file in launch.launch_files}


@kept
def _readers(launch: Launch) -> dict[str, list[LaunchFile]]:
    """Launch configuration -> the files that read it."""
    found: dict[str, list[LaunchFile]] = {}
    for file in launch.launch_files:
        for name in _reads(launch)[id(file)]:
            found.setdefault(name, []).append(file)
    return found


def read_elsewhere(launch: Launch, name: str, file: LaunchFile, inner: list[LaunchFile]) -> bool:
    """Whether a configuration that leaks out of an include is read by another file that runs together with it."""
    inside = {id(file), *map(id, inner)}
    readers = (each for each in _readers(launch).get(name, ()) if id(each) not in inside)
    together = {id(each) for expansion in launch.leading_to(file) for each in expansion.files}
    return any(id(each) in together for each in readers)


def unknown_before(expansion: Expansion, include: Included) -> bool:
    """Whether something before an include may set arguments unseen: an include that is not in the tree."""
    for other in expansion.includes:
        if other is include:
            return False
        if other.target is None:
            return True
    return False


def started_without(launch: Launch, file: LaunchFile, name: str) -> Iterator[Span]:
    """Where launch files and scripts of the robot start a file and leave an argument to its default."""
    yield from _included_without(launch, file, name)
    command = re.compile(rf"ros2 launch [^\n;&|]*\b{re.escape(file.source.basename)}(?![\w.])[^\n;&|\"']*")
    for script in launch.files.of_kind("shell-script"):
        if launch.files.purpose(script) is not Purpose.ROBOT:
            continue
        yield from (
            script.span(*match.span()) for match in command.finditer(script.text) if f"{name}:=" not in match[0]
        )


def _included_without(launch: Launch, file: LaunchFile, name: str) -> Iterator[Span]:
    for expansion in launch.leading_to(file):
        if launch.simulated(expansion.entry):
            continue
        for include in expansion.includes:
            if include.target is file and name not in include.arguments and name not in include.known:
                yield include.action.span


def dead_reads(file: LaunchFile, name: str) -> int:
    """How often a launch configuration is bound to a variable that is used nowhere, or only as the default of the
    argument itself."""
    variables = (variable for read, variable in file.bound if read.name == name)
    return sum(uses(file.source.uncommented, variable, name) == 1 for variable in variables)


def uses(text: str, variable: str, name: str) -> int:
    """How often a variable is named, without the place that makes it the default of the argument ``name``."""
    written = re.escape(variable)
    own_default = rf"""(['"]){re.escape(name)}\1\s*,\s*default_value\s*=\s*{written}(?!\w)"""
    named = len(re.findall(rf"(?<![\w.'\"]){written}(?![\w'\"])", text))
    return named - len(re.findall(own_default, text))
