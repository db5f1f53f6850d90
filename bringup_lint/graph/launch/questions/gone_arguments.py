"""Arguments that public launch files have no longer, as they are passed, or declared around an include."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.gone_parameters import Gone
from bringup_lint.facts.ros.gone_parameters import gone_argument
from bringup_lint.graph.launch.questions.public_includes import of_public
from bringup_lint.graph.launch.reads import read_elsewhere
from bringup_lint.graph.launch.reads import read_in
from bringup_lint.model.launch_values import literal
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.expansion import Included
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.model.launch import LaunchFile


class GoneArgument(NamedTuple):
    name: Located
    target: str
    """The name of the included file."""
    gone: Gone


def gone_arguments(launch: Launch, file: LaunchFile) -> Iterator[list[GoneArgument]]:
    """By included file and release, what a launch file passes to it or declares for it; each place once."""
    expansion, named = launch.expansion(file), launch.files.target.named
    found: dict[tuple[str, str, str], dict[int, GoneArgument]] = {}
    for include, package, target, _ in of_public(launch, expansion.includes):
        passed = {literal(key) for key, _ in include.action.arguments}
        passed |= {literal(each.action.name) for each in expansion.declared}
        for name in _given(launch, expansion, include):
            gone = gone_argument(package, target, str(name))
            if gone is not None and gone.is_for(named) and gone.now not in passed:
                group = found.setdefault((package, target, gone.since), {})
                group.setdefault(name.span.start, GoneArgument(name, target, gone))
    yield from (sorted(group.values(), key=lambda each: each.name.span.start) for group in found.values())


def _given(launch: Launch, expansion: Expansion, include: Included) -> Iterator[Located]:
    """What reaches an included file from the entry: arguments that this passes to it itself, and those that it declares
    and nothing of the tree reads."""
    entry = expansion.entry
    if include.source is entry:
        passed = (name for key, _ in include.action.arguments if (name := literal(key)) is not None)
        yield from (name for name in passed if not read_elsewhere(launch, name, entry, []))
    read = read_in(launch, expansion.files)
    for each in expansion.declared:
        name = literal(each.action.name) if each.file is entry else None
        if name is not None and name in include.known and name not in read:
            yield name
