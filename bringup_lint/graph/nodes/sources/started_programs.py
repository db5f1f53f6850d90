"""The Python programs of the tree that units and other runners start by their paths."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.model.shell import Command

_PYTHON = regex(r"python[0-9.]*$")


def started_programs(files: Files, runners: Runners) -> list[Source]:
    """Each once, in the order in which they are started."""
    found = (files.find(str(path), path.span.source) for path in _paths(runners))
    return list(dict.fromkeys(each for each in found if each is not None))


def _paths(runners: Runners) -> Iterator[Located]:
    for runner in runners.all:
        for line in runner.lines:
            for step in line.steps:
                path = program_path(step.command)
                if path is not None and path.endswith(".py") and "$" not in path:
                    yield path


def program_path(command: Command) -> Located | None:
    """What a command starts, or what it gives to Python to run."""
    words = unwrapped(command.words)
    if words and _PYTHON.match(program_name(words[0])):
        return next((word for word in words[1:] if not word.startswith("-")), None)
    return words[0] if words else None
