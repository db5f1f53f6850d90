"""Values that an include or a command gives to an argument and that are none of its choices."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.expansion import Declared
from bringup_lint.graph.runners.launching import expansion_of
from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch_values import literal
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runners import Runners


class RefusedChoice(NamedTuple):
    value: Located
    """What the argument has when it is declared."""
    declared: Declared
    choices: list[Located]
    always: bool
    """Whoever launches the file cannot change it."""


def choices_of(action: DeclareArgument) -> list[Located]:
    """Empty when there are none, or when one of them is not known."""
    found = [literal(choice) for choice in action.choices or ()]
    known = [choice for choice in found if choice is not None]
    return known if len(known) == len(found) else []


def refused_choices(launch: Launch, runners: Runners) -> Iterator[RefusedChoice]:
    """Each place once: what launch files and the commands of runners give."""
    if not any(choices_of(action) for _, action in launch.actions(DeclareArgument)):
        return
    seen = set()
    for expansion in _all(launch, runners):
        for declared in expansion.declared:
            found = _refused(declared)
            if found is not None and (found.value.span, declared.action.span) not in seen:
                seen.add((found.value.span, declared.action.span))
                yield found


def _all(launch: Launch, runners: Runners) -> Iterator[Expansion]:
    yield from launch.entries
    for command in runners.launches:
        if command.file is not None and command.runner.certain and command.arguments:
            expansion = expansion_of(command.start.ros, launch)
            if expansion is not None:
                yield expansion


def _refused(declared: Declared) -> RefusedChoice | None:
    value = literal(declared.before.value) if declared.before is not None else None
    choices = choices_of(declared.action)
    if declared.before is None or value is None or not choices or value in choices:
        return None
    fixed = literal(declared.before.symbol) is not None and not declared.conditions
    return RefusedChoice(value, declared, choices, fixed)
