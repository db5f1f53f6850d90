"""What scripts and Dockerfiles install with apt."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import commands
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_INSTALLERS = frozenset(("apt", "apt-get", "aptitude"))


def installations(files: Files, dockerfiles: Iterable[Dockerfile]) -> Iterator[tuple[Source, Command]]:
    """The commands of scripts and Dockerfiles that install packages with apt."""
    for source, script in _scripts(files, dockerfiles):
        for command in commands(script):
            words = [word.rpartition("/")[2] for word in command.words]
            if "install" in words and _INSTALLERS & set(words):
                yield source, command


def _scripts(files: Files, dockerfiles: Iterable[Dockerfile]) -> Iterator[tuple[Source, Located]]:
    for source in files.of_kind("shell-script"):
        if "install" in source.text:
            yield source, source.located(0, len(source.text))
    for file in dockerfiles:
        for instruction in file.instructions:
            if instruction.name == "RUN":
                yield from ((file.source, script) for script in instruction.scripts)
