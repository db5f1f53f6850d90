"""Arguments that launch files declare and that nothing reads, be it that one file hands them on to the next."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.launch_arguments import OF_LAUNCH
from bringup_lint.graph.launch.reads import uses
from bringup_lint.graph.memo import kept
from bringup_lint.graph.memo import memo
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import literal
from bringup_lint.model.launch_values import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Declared
    from bringup_lint.graph.launch.expansion import Included
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.model.launch import Include
    from bringup_lint.model.launch import LaunchFile


class UnreadArgument(NamedTuple):
    declared: Declared
    passed: list[Located]
    """Where files that include this one give it a value."""
    is_shared: bool
    """Another file of this name declares it too: both offer what a third one may include under a computed path."""
    instead: Argument | None
    """Another argument that a variable of this name reads."""


def unread_arguments(launch: Launch, file: LaunchFile) -> Iterator[UnreadArgument]:
    own = launch.expansion(file)
    if own.opaque or own.is_lost or any(each.reads_all for each in own.files):
        return
    others = {id(each): each for expansion in launch.leading_to(file) for each in expansion.files if each is not file}
    elsewhere = own.outside.union(OF_LAUNCH, *(_read(launch)[other] for other in others))
    later = {str(each.name) for each in _handed(launch)[id(file)]}
    later |= {each.name for each in own.declared if each.file is not file}
    for declared in own.declared:
        name = declared.name
        if declared.file is not file or name in elsewhere or name in later:
            continue
        if name not in _read(launch)[id(file)] and _mentioned(launch, file, name) <= 1 + _idle(launch, file)[name]:
            is_shared = _declaring(launch)[file.source.basename, name] > 1
            yield UnreadArgument(declared, _passed(launch, file, name), is_shared, _instead(file, name))


def _instead(file: LaunchFile, name: str) -> Argument | None:
    """What a variable that is called like an argument, or like its last words, reads in its place."""
    found = (read for read, variable in file.bound if _is_for(variable, name) and not _is_for(variable, read.name))
    return next(found, None)


def _is_for(variable: str, name: str) -> bool:
    return f"_{name}".endswith(f"_{variable}")


@kept
def _declaring(launch: Launch) -> Counter[tuple[str, str]]:
    """How many launch files of a name declare an argument."""
    return Counter(
        (file.source.basename, name)
        for file in launch.launch_files
        for name in {each.name for each in launch.expansion(file).declared if each.file is file}
    )


def _passed(launch: Launch, file: LaunchFile, name: str) -> list[Located]:
    includes: dict[int, Included] = {}
    for expansion in launch.leading_to(file):
        includes.update((each.action.key, each) for each in expansion.includes if each.target is file)
    keys = [literal(key) for each in includes.values() for key, _ in each.action.arguments]
    return [key for key in keys if key == name]


@kept
def _handed(launch: Launch) -> dict[int, list[Argument]]:
    """By file, what its includes hand on to a file of the tree under the same name."""
    found: dict[int, list[Argument]] = {id(file): [] for file in launch.launch_files}
    for file in launch.launch_files:
        includes = {each.action.key: each for each in launch.expansion(file).includes if each.source is file}
        for include in includes.values():
            if include.target is not None:
                found[id(file)] += _handed_by(include.action, file.format == "python")
    return found


def _handed_by(include: Include, is_python: bool) -> Iterator[Argument]:
    """Only what stands in the include itself: a dictionary that lies elsewhere may have further uses."""
    for key, value in include.arguments:
        name = literal(key)
        is_inside = not is_python or (name is not None and include.span.start <= name.span.start < include.span.end)
        if name is not None and is_inside:
            yield from (each for each in walk(value) if isinstance(each, Argument) and each.name == name)


@kept
def _read(launch: Launch) -> dict[int, frozenset[str]]:
    """What each file reads for more than to hand it on."""
    return {id(file): frozenset(_used(launch, file)) for file in launch.launch_files}


def _used(launch: Launch, file: LaunchFile) -> Iterator[str]:
    idle = {id(each) for each in _idle_reads(launch, file)}
    return (str(read.name) for read in file.reads if id(read) not in idle)


def _idle_reads(launch: Launch, file: LaunchFile) -> Iterator[Argument]:
    """Those that are bound to a variable which is used nowhere, or only as the default of the argument itself, and what
    is only handed on."""
    handed = Counter(each.span.start for each in _handed(launch)[id(file)])
    bound: dict[int, list[str]] = {}
    for read, variable in file.bound:
        bound.setdefault(id(read), []).append(variable)
    for read in file.reads:
        count = handed[read.span.start]
        variables = bound.get(id(read))
        if variables is None:
            if count:
                yield read
        elif all(uses(file.source.uncommented, each, str(read.name)) <= 1 + count for each in variables):
            yield read


@memo
def _idle(launch: Launch, file: LaunchFile) -> Counter[str]:
    """How often a file mentions each name without an effect, other than where it declares it."""
    return Counter(str(read.name) for read in _idle_reads(launch, file))


def _mentioned(launch: Launch, file: LaunchFile, name: str) -> int:
    """In Python only quoted names count: a variable may have the same name as the argument, and a key of a dictionary
    gives a parameter or an argument of another file."""
    if file.format != "python":
        return launch.mentions(file, name)
    return len(re.findall(rf"""(['"]){re.escape(name)}\1(?!\s*:)""", file.source.text))
