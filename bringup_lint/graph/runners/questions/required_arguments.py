"""Launch arguments without a default that an include or a command does not pass."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.expansion import Declared
from bringup_lint.graph.launch.expansion import Included
from bringup_lint.graph.launch.reads import unknown_before
from bringup_lint.graph.runners.launching import Launching
from bringup_lint.model.launch import LaunchFile
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runners import Runners


class NotPassed(NamedTuple):
    declared: Declared
    by: Included | Launching
    """What starts the file without the argument."""


def not_passed(launch: Launch, runners: Runners) -> Iterator[NotPassed]:
    """The arguments that are surely missing: launch aborts where they are needed."""
    yield from _by_includes(launch)
    for command in runners.launches:
        if command.file is not None and command.runner.certain:
            passed = {str(name) for name, _ in command.arguments}
            for declared in _required(launch, command.file):
                if declared.before is None and declared.name not in passed:
                    yield NotPassed(declared, command)


def _by_includes(launch: Launch) -> Iterator[NotPassed]:
    for expansion in launch.entries:
        for include in expansion.includes:
            if include.target is None or include.action.open:
                continue
            known = set(include.arguments) | include.known
            for declared in _required(launch, include.target):
                if declared.name in known or declared.before is not None:
                    continue
                if not unknown_before(expansion, include):
                    yield NotPassed(declared, include)


def _required(launch: Launch, file: LaunchFile) -> Iterator[Declared]:
    """What a file itself declares without a default, in any case."""
    for declared in launch.expansion(file).declared:
        if declared.file is file and not declared.conditions and declared.action.default is None:
            yield declared
