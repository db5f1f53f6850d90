"""What scripts and Dockerfiles install with apt."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.model.shell import Command
from bringup_lint.parsers.dockerfile import commands_of_run
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_INSTALLERS = frozenset(("apt", "apt-get", "aptitude"))


def installations(files: Files, dockerfiles: Iterable[Dockerfile]) -> Iterator[tuple[Source, Command]]:
    """The commands of scripts and Dockerfiles that install packages with apt."""
    for source, command in _commands(files, dockerfiles):
        words = [word.rpartition("/")[2] for word in command.words]
        if "install" in words and _INSTALLERS & set(words):
            yield source, command


def _commands(files: Files, dockerfiles: Iterable[Dockerfile]) -> Iterator[tuple[Source, Command]]:
    for source in files.of_kind("shell-script"):
        if "install" in source.text:
            yield from ((source, command) for command in shell_commands(source))
    for file in dockerfiles:
        for instruction in file.instructions:
            if instruction.name == "RUN":
                yield from ((file.source, command) for command in commands_of_run(instruction))
