"""Packages that are built or installed without the rest of their workspace, with nothing but what they declare."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.graph.purpose import Purpose
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package
    from bringup_lint.graph.workspace import Workspace

_UP_TO = regex(r"--packages-up-to(?:(?:[ \t]|\\\r?\n){1,40}[A-Za-z]\w{0,80}(?![\w$.{/-])){1,40}")
_NAME = regex(r"(?<![\w-])[A-Za-z]\w*")
_BUILD = regex(r"\bcolcon\s+build\b(?:\\\r?\n|[^\n;&|]){0,2000}")
_CHANGELOG = regex(r"^changelog for package (\w+)[ \t]*$", re.I | re.M)
_RELEASE = regex(r"^\d+\.\d+\.\d+ \(\d{4}-\d\d-\d\d\)", re.M)
_HEAD = 8_000
"""Characters of a changelog that are looked at."""


class Selection(NamedTuple):
    command: Located
    built: frozenset[str]
    """The packages that colcon builds: those that the command names, and what they depend on."""


class Apart:
    def __init__(self, files: Files, workspace: Workspace) -> None:
        self._files = files
        self._workspace = workspace

    def leaving_out(self, owner: Package, name: str) -> Located | None:
        """The command of a script or an image that builds a package, and nowhere in its file another one."""
        for selection in self._selections:
            if owner.name in selection.built and name not in selection.built:
                if name not in selection.command.span.source.text:
                    return selection.command
        return None

    @cached_property
    def _selections(self) -> list[Selection]:
        sources = self._files.of_kind("dockerfile", "shell-script")
        return [each for source in sources for each in self._of(source)]

    def _of(self, source: Source) -> Iterator[Selection]:
        if not source.judged or self._files.purpose(source) is not Purpose.ROBOT:
            return
        if any("--packages-" not in command for command in _BUILD.findall(source.text)):
            return
        for match in _UP_TO.finditer(source.text):
            named = _NAME.findall(match[0].partition("up-to")[2])
            built = frozenset(each for name in named for each in self._closure(name))
            yield Selection(source.located(match.start(), match.end()), built)

    def _closure(self, name: str) -> Iterator[str]:
        yield name
        package = self._workspace.packages.get(name)
        if package is not None:
            yield from map(str, self._workspace.required(package))
