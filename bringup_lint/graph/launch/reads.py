"""Which files read a launch configuration, and who starts a file without it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.unknown_folders import last_name
from bringup_lint.graph.memo import kept
from bringup_lint.graph.purpose import Purpose
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import walk
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.expansion import Included
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.model.launch import LaunchFile
    from bringup_lint.source import Span

_VARIABLE = regex(r"\$\(var\s{1,20}['\"]?([^\s()'\"]+)", hints="$(var")

_QUOTED = regex(r""""[^"\\\n]*(?:\\.[^"\\\n]*)*"|'[^'\\\n]*(?:\\.[^'\\\n]*)*'""")


def reads_unseen(launch: Launch, files: Iterable[LaunchFile]) -> bool:
    """Whether files may read launch configurations by names that are not known: by computed names, or in parameter
    files with substitutions that are not in the tree."""
    unseen = _unseen(launch)
    return any(id(file) in unseen for file in files)


@kept
def _unseen(launch: Launch) -> frozenset[int]:
    known = _substituted(launch)
    return frozenset(
        id(file) for file in launch.launch_files if file.reads_all or any(name not in known for name in _filled(file))
    )


def _filled(file: LaunchFile) -> Iterator[str]:
    """The names of the parameter files that launch fills in for a launch file; empty where one is not known."""
    for action in walk_actions(file.actions):
        for source in getattr(action, "parameters", ()):
            for each in walk(source):
                if isinstance(each, ParameterFile) and each.allow_substs is not None:
                    yield last_name(each.file).rpartition("/")[2]


@kept
def _substituted(launch: Launch) -> dict[str, set[str]]:
    """By the name of a parameter file, the launch configurations that it reads where launch fills it in."""
    found: dict[str, set[str]] = {}
    for source in launch.files.of_kind("params"):
        found.setdefault(source.basename, set()).update(_VARIABLE.findall(source.text))
    return found


def read_in(launch: Launch, files: Iterable[LaunchFile]) -> set[str]:
    """The launch configurations that files read, in parameter files, too."""
    reads = _reads(launch)
    return set().union(*(reads[id(file)] for file in files))


@kept
def _reads(launch: Launch) -> dict[int, frozenset[str]]:
    filled = _substituted(launch)
    return {
        id(file): frozenset(str(argument.name) for argument in file.reads).union(
            *(filled.get(name, ()) for name in _filled(file))
        )
        for file in launch.launch_files
    }


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
    named = len(re.findall(rf"(?<![\w.'\"]){written}(?![\w'\"])", _QUOTED.sub(_kept, text)))
    return named - len(re.findall(own_default, text))


def _kept(quoted: re.Match[str]) -> str:
    """A text names no variable, unless it is filled in."""
    return quoted[0] if "{" in quoted[0] else ""
