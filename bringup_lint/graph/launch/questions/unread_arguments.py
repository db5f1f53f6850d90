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
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import literal
from bringup_lint.model.launch_values import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Declared
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.expansion import Included
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.model.launch import Include
    from bringup_lint.model.launch import LaunchFile
    from bringup_lint.model.launch_values import Value


class UnreadArgument(NamedTuple):
    declared: Declared
    passed: list[Located]
    """Where files that include this one give it a value."""
    is_shared: bool
    """Another file of this name declares it too, or it is passed under a computed path: several offer what a third one
    may include."""
    instead: Argument | None
    """Another argument that a variable of this name reads."""


def unread_arguments(launch: Launch, file: LaunchFile) -> Iterator[UnreadArgument]:
    own = launch.expansion(file)
    if own.opaque or any(each.reads_all for each in own.files) or _may_be_read_outside(launch, own):
        return
    below = own.outside.union(OF_LAUNCH, *(_read(launch)[id(each)] for each in own.files if each is not file))
    others = {id(each) for expansion in launch.leading_to(file) for each in expansion.files if each is not file}
    beside = frozenset[str]().union(*(_read(launch)[other] for other in others))
    later = {str(each.name) for each in _handed(launch)[id(file)]}
    later |= {each.name for each in own.declared if each.file is not file}
    for declared in own.declared:
        name = declared.name
        if declared.file is not file or name in below or name in later:
            continue
        if name in beside and not _is_handed_here(launch, file, name):
            continue
        if name not in _read(launch)[id(file)] and _mentioned(launch, file, name) <= 1 + _idle(launch, file)[name]:
            is_shared = _declaring(launch)[file.source.basename, name] > 1 or name in _passed_somewhere(launch)
            yield UnreadArgument(declared, _passed(launch, file, name), is_shared, _instead(file, name))


def _may_be_read_outside(launch: Launch, own: Expansion) -> bool:
    """Whether a file that nothing is known of may read an argument of the entry without getting it from who includes
    it: the entry does so itself, or it gets nothing."""
    if not own.is_lost:
        return False
    lost = [each for each in own.includes if each.target is None]
    return any(each.source is own.entry or not each.action.arguments or not _is_foreign(launch, each) for each in lost)


def _is_foreign(launch: Launch, included: Included) -> bool:
    """Whether a file is one of a package that the tree does not hold."""
    shares = [literal(each.package) for each in walk(included.file) if isinstance(each, PackageShare)]
    return bool(shares) and all(each is not None and each not in launch.workspace.packages for each in shares)


def _is_handed_here(launch: Launch, file: LaunchFile, name: str) -> bool:
    """Whether all that include a file hand on their own argument of this name, so that the file changes nothing for
    them when it declares it."""
    return all(any(_is_own(pair, name) for pair in each.action.arguments) for each in _includes_of(launch, file))


def _is_own(passed: tuple[Value, Value], name: str) -> bool:
    key, value = passed
    return literal(key) == name and any(isinstance(each, Argument) and each.name == name for each in walk(value))


def _instead(file: LaunchFile, name: str) -> Argument | None:
    """What a variable that is called like an argument, or like its last words, reads in its place."""
    found = (read for read, variable in file.bound if _is_for(variable, name) and not _is_for(variable, read.name))
    return next(found, None)


def _is_for(variable: str, name: str) -> bool:
    return f"_{name}".endswith(f"_{variable}")


@kept
def _passed_somewhere(launch: Launch) -> frozenset[str]:
    """The arguments that are passed to files of which the path is not known."""
    includes = (each for expansion in launch.expansions for each in expansion.includes if each.target is None)
    computed = (each for each in includes if launch.place(each.file) is None and not _is_foreign(launch, each))
    return frozenset(name for each in computed for name in each.arguments)


@kept
def _declaring(launch: Launch) -> Counter[tuple[str, str]]:
    """How many launch files of a name declare an argument."""
    return Counter(
        (file.source.basename, name)
        for file in launch.launch_files
        for name in {each.name for each in launch.expansion(file).declared if each.file is file}
    )


def _passed(launch: Launch, file: LaunchFile, name: str) -> list[Located]:
    keys = [literal(key) for each in _includes_of(launch, file) for key, _ in each.action.arguments]
    return [key for key in keys if key == name]


@memo
def _includes_of(launch: Launch, file: LaunchFile) -> list[Included]:
    """What includes a file, each once."""
    includes: dict[int, Included] = {}
    for expansion in launch.leading_to(file):
        includes.update((each.action.key, each) for each in expansion.includes if each.target is file)
    return [*includes.values()]


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


def is_used(launch: Launch, file: LaunchFile, name: str) -> bool:
    """Whether a file does more with an argument than to hand it on."""
    return name in _read(launch)[id(file)]


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
