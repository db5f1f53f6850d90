"""Includes of launch files of public packages, compared with the arguments that these take."""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.launch_arguments import Taken
from bringup_lint.facts.ros.launch_arguments import taken
from bringup_lint.graph.launch.reads import read_elsewhere
from bringup_lint.graph.launch.reads import unknown_before
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch_values import literal
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.expansion import Included
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.model.launch import LaunchFile


_HARMLESS = frozenset(("use_sim_time", "namespace"))
"""What is passed to every include, and not to all of them for an effect."""


class Untaken(NamedTuple):
    """An argument that an included public launch file does not take."""

    include: Included
    name: Located
    package: str
    target: str
    """The name of the included file."""
    near: str | None
    """The argument that is meant, if the name is close to one."""


def untaken(launch: Launch, file: LaunchFile) -> Iterator[Untaken]:
    for include, package, target, known in _public(launch, file):
        unknown = _unknown(launch, file, include, known)
        if len(unknown) == 1 and len(_missing(include, known)) == 1:
            continue  # the required one is meant, and reported as missing
        for name in unknown:
            near = nearest(name, sorted(known.arguments))
            if near or not known.grows:
                yield Untaken(include, name, package, target, near[0] if near else None)


class Unpassed(NamedTuple):
    """A required argument of an included public launch file that nothing passes."""

    include: Included
    name: str
    target: str
    """The name of the included file."""
    instead: Located | None
    """What is passed in its place, and not taken."""


def unpassed(launch: Launch, file: LaunchFile) -> Iterator[Unpassed]:
    expansion = launch.expansion(file)
    for include, _, target, known in _public(launch, file):
        if include.action.open or _may_be_set(launch, expansion, include):
            continue
        missing, unknown = _missing(include, known), _unknown(launch, file, include, known)
        instead = unknown[0] if len(unknown) == 1 and len(missing) == 1 else None
        for name in missing:
            yield Unpassed(include, name, target, instead)


def _missing(include: Included, known: Taken) -> list[str]:
    return sorted(known.required - include.arguments.keys() - include.known)


def _unknown(launch: Launch, file: LaunchFile, include: Included, known: Taken) -> list[Located]:
    names = (literal(key) for key, _ in include.action.arguments)
    given = [name for name in names if name is not None and name not in known.arguments and name not in _HARMLESS]
    return [name for name in given if not read_elsewhere(launch, name, file, [])]


def _may_be_set(launch: Launch, expansion: Expansion, include: Included) -> bool:
    """Whether something else may set the argument before: an include of this file, or a file that includes it."""
    return unknown_before(expansion, include) or id(expansion.entry) in launch.included


def _public(launch: Launch, file: LaunchFile) -> Iterator[tuple[Included, str, str, Taken]]:
    return of_public(launch, (each for each in launch.expansion(file).includes if each.source is file))


def of_public(launch: Launch, includes: Iterable[Included]) -> Iterator[tuple[Included, str, str, Taken]]:
    """The includes of known public launch files, each with the package and the name of the file."""
    for include in includes:
        where = place(include.file) if include.target is None else None
        if where is None or where.base != "share" or _is_in_tree(launch, where.package):
            continue
        target = os.path.basename(where.path)
        known = taken(where.package, target)
        if known is not None:
            yield include, where.package, target, known


def _is_in_tree(launch: Launch, package: str) -> bool:
    return package in launch.workspace.packages or package in launch.workspace.ambiguous
