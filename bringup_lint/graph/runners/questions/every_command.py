"""Every command that a shell or a runner reads: in scripts, build steps, tasks and command lines, and within others."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.shells import shell_input
from bringup_lint.graph.commands.typed import TERMINALS
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.installed.scripts import SIZE
from bringup_lint.model.shell import Command
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers.ansible_tasks import tasks
from bringup_lint.parsers.dockerfile import commands_of
from bringup_lint.parsers.shell import commands
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.parsers.shell_tokens import substitutions

if TYPE_CHECKING:
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.model.dockerfile import Instruction
    from bringup_lint.source import Located

_DEEPEST = 4
_RUNS = ("-e", "-x", "-c", "--", "--command", "--execute")
"""Options of terminals before the command."""
_OF_TASKS = ("shell", "command")


def every_command(runners: Runners) -> Iterator[Command]:
    """Those of judged files that are no templates, each once, with the ones in ``$(...)`` and after ``sh -c``."""
    seen = set()
    for command in with_inner(_outer(runners)):
        place = command.words[0].span if command.words else None
        if place not in seen or place is None:
            seen.add(place)
            yield command


def _outer(runners: Runners) -> Iterator[Command]:
    files = runners.files
    for source in files.of_kind("shell-script"):
        if source.judged and not source.template and len(source.text) <= SIZE:
            yield from shell_commands(source)
    if files.of_kind("dockerfile"):
        for file in runners.layers.compose().images.dockerfiles:
            if file.source.judged:
                for stage in file.stages:
                    yield from commands_of(stage)
                    yield from map(_in_exec_form, stage.all("SHELL", "ENTRYPOINT", "CMD"))
    for source in files.of_kind("ansible"):
        if source.judged:
            for task in tasks(source):
                for module in task.modules:
                    if module.name in _OF_TASKS:
                        yield from _of_task(module.settings)
    for runner in runners.all:
        if not runner.source.template:
            yield from (step.command for line in runner.lines for step in line.steps if step.script is None)


def _in_exec_form(instruction: Instruction) -> Command:
    """The program of the JSON form, where it is written as it is."""
    words = instruction.exec_form or [""]
    at = instruction.value.find(f'"{words[0]}"') if words[0] else -1
    return Command((instruction.value.part(at + 1, at + 1 + len(words[0])),) if at > 0 else ())


def _of_task(settings: Node) -> Iterable[Command]:
    given = settings.scalar("cmd") if isinstance(settings, Mapping) else settings
    return commands(given.value) if isinstance(given, Scalar) else ()


def with_inner(found: Iterable[Command], depth: int = 0) -> Iterator[Command]:
    """Commands, each with those that further shells read of it."""
    in_condition = False
    for command in found:
        was_in, in_condition = in_condition, _opens_condition(command, in_condition)
        if not was_in:
            yield command
        if depth < _DEEPEST:
            for text in _texts(command):
                yield from with_inner(commands(text), depth + 1)


def _opens_condition(command: Command, is_open: bool) -> bool:
    """Whether ``[[ a =~ b|c ]]``, of which each part behind an operator looks like a command, goes on behind it."""
    return (is_open or command.words[:1] == ("[[",)) and "]]" not in command.words


def _texts(command: Command) -> Iterator[Located]:
    """What further shells read of a command."""
    for word in (*command.assignments, *command.words):
        yield from substitutions(word)
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    if name in TERMINALS:
        yield from _typed(words)
    else:
        yield from _read(name, words[1:])


def _read(name: str, words: tuple[Located, ...]) -> Iterator[Located]:
    read = shell_input(words) if name in SHELLS else None
    if read is not None and read.text is not None:
        yield read.text


def _typed(words: tuple[Located, ...]) -> Iterator[Located]:
    """What a terminal is given to run: a word with blanks that is no title, or what a shell in it reads."""
    for at, word in enumerate(words[1:], 1):
        before = words[at - 1]
        if program_name(word) in SHELLS:
            yield from _read(program_name(word), words[at + 1 :])
            return
        if " " in word and not word.startswith("-") and (before in _RUNS or not before.startswith("-")):
            yield word
