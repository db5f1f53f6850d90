"""Dockerfiles: stages and their instructions."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

VARIABLE = regex(r"\$(?:\{(?P<braced>\w+)(?::-(?P<default>[^}]{0,400}))?\}|(?P<plain>\w+))")


@dataclass(eq=False, slots=True)
class Instruction:
    """One instruction. ``value`` has its continued lines joined; comments between them are gone."""

    name: str
    """In capitals."""
    keyword: Located
    value: Located
    flags: tuple[Located, ...] = ()
    """``--mount=...`` and the like, which are before the value."""
    heredocs: list[Located] = field(default_factory=list)
    """The texts of here-documents."""

    @property
    def exec_form(self) -> list[str] | None:
        """The words of the JSON form; None for the shell form."""
        if not self.value.startswith("["):
            return None
        import json

        try:
            words = json.loads(str(self.value))
        except ValueError:
            return None
        return words if isinstance(words, list) and all(isinstance(word, str) for word in words) else None

    @property
    def scripts(self) -> list[Located]:
        """What a shell reads: the text of the shell form, or the here-documents that it is given."""
        return self.heredocs if self.value.startswith("<<") else [self.value]


@dataclass(eq=False)
class Stage:
    """What is between one FROM and the next."""

    start: Instruction
    image: Located
    name: Located | None = None
    instructions: list[Instruction] = field(default_factory=list)
    base: Stage | None = None
    """The earlier stage that it builds on; None for an image from elsewhere."""
    resolved: str = ""
    """The image with the defaults of global ARGs put in; a variable without default stays as written."""
    earlier: tuple[Stage, ...] = ()
    """The stages before it that it may build on, where a variable without a value names its image."""
    arguments: Mapping[str, Located | None] = field(default_factory=dict)
    """The global ARGs of the file, with their defaults: an ARG of the stage without a default takes these."""

    def all(self, *names: str) -> Iterator[Instruction]:
        return (instruction for instruction in self.instructions if instruction.name in names)

    @property
    def chain(self) -> Iterator[Stage]:
        """The stage and those that it builds on."""
        stage: Stage | None = self
        while stage is not None:
            yield stage
            stage = stage.base

    def last(self, name: str) -> Instruction | None:
        """The instruction that counts, looked for in the stages below too."""
        for stage in self.chain:
            found = list(stage.all(name))
            if found:
                return found[-1]
        return None

    @property
    def origin(self) -> str:
        """The image at the bottom of the chain."""
        return list(self.chain)[-1].resolved


_FROM = regex(r"(?:--|,)from=([\w.-]+)")
"""The stage of a COPY, or of a mount of RUN."""


@dataclass(eq=False)
class Dockerfile:
    source: Source
    stages: list[Stage] = field(default_factory=list)
    arguments: dict[str, Located | None] = field(default_factory=dict)
    """ARGs before the first FROM, with their defaults."""
    problems: list[Problem] = field(default_factory=list)
    _named: dict[str, Stage] = field(default_factory=dict)
    """The first stage of each name, in lower case."""

    def add(self, stage: Stage) -> None:
        self.stages.append(stage)
        if stage.name:
            self._named.setdefault(stage.name.lower(), stage)

    @property
    def final(self) -> Stage | None:
        """The stage that becomes the image when no target is named."""
        return self.stages[-1] if self.stages else None

    def stage(self, name: str) -> Stage | None:
        return self._named.get(name.lower())

    def needed(self, images: Iterable[Stage]) -> set[Stage]:
        """The stages that a build of these images runs: those below them, and those from which files are taken."""
        found: set[Stage] = set()
        todo = list(images)
        while todo:
            for stage in todo.pop().chain:
                if stage in found:
                    break
                found.add(stage)
                flags = (flag for each in stage.instructions for flag in each.flags)
                names = (match[1] for flag in flags for match in _FROM.finditer(flag))
                todo += [each for name in names if (each := self.taken(name)) is not None]
        return found

    def taken(self, name: str) -> Stage | None:
        """The stage that ``--from=`` names, by its name or its number."""
        if name.isdecimal() and len(name) < 5:
            return self.stages[int(name)] if int(name) < len(self.stages) else None
        return self.stage(name)

    @cached_property
    def instructions(self) -> list[Instruction]:
        return [instruction for stage in self.stages for instruction in stage.instructions]

    def expand(self, text: str) -> str:
        """Put in the defaults of the global arguments; an empty one has to be given to the build."""
        return substituted(text, self.arguments)


def substituted(text: str, values: Mapping[str, str | None]) -> str:
    """Put in the values of variables. One that is empty or has no value gets its ``:-`` default, else it stays as it
    is written."""

    def value(match: re.Match[str]) -> str:
        found = values.get(match["braced"] or match["plain"])
        return str(found or match["default"] or match[0])

    return VARIABLE.sub(value, text)


_EXEC = regex(r"(?:^|&&|;)\s*exec\s")


def stays_in_shell(stage: Stage, instruction: Instruction) -> bool:
    """Whether the first process is a shell of the image that hands on no signal: a command in shell form without exec,
    for ``/bin/sh`` (dash keeps its process; bash, of which SHELL speaks, gives it up for the last command)."""
    if instruction.exec_form is not None or _EXEC.search(instruction.value):
        return False
    return not any(each.last("SHELL") for each in stage.chain)
