"""Python files of packages that nothing runs: no console script, installation, launch file or import names them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.graph.modules import modules
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.source import Source

_NAMING = (
    *("systemd-unit", "systemd-dropin", "compose", "dockerfile", "shell-script", "supervisord", "env-file"),
    *("launch-python", "launch-xml", "launch-yaml", "cmake", "setup-py"),
)
"""Kinds of files that start or install others by their names."""
_IMPORT = regex(r"(?m)^[ \t]*(?:from|import)\b[^\n#(]*(?:\([^()]*\))?")
_MODULE = regex(r"[ \t\"']-[A-Za-z]{0,8}m[\"', \t]{1,8}(?P<module>\w[\w.]*)")
_WORD = regex(r"\w+")
_TEXT = regex(r"""["']([\w.]{2,80})["']""")
"""What ``importlib`` and the like may be given."""


class Unused:
    def __init__(self, files: Files, workspace: Workspace) -> None:
        self._files = files
        self._workspace = workspace

    def has(self, source: Source) -> bool:
        """Whether a file is in a package whose programs are all known, and is none of them nor a part of one."""
        owner = self._workspace.owner(source)
        name = source.basename.removesuffix(".py")
        if owner is None or not owner.executables_known or name.startswith("__") or name == source.basename:
            return False
        if not owner.entry_points and not owner.executables:
            return False
        targets = (target.partition(":")[0].rpartition(".")[2] for target in owner.entry_points.values())
        if name in targets or owner.takes(source.absolute) or source.basename in self._named or name in self._run:
            return False
        return name not in self._imported

    @cached_property
    def _named(self) -> str:
        return "\0".join(source.text for source in self._files.of_kind(*_NAMING))

    @cached_property
    def _run(self) -> frozenset[str]:
        """The last parts of the modules that commands run with ``python3 -m``."""
        return frozenset(match["module"].rpartition(".")[2] for match in _MODULE.finditer(self._named))

    @cached_property
    def _imported(self) -> frozenset[str]:
        """Every word of an import, and of a text that may name a module."""
        return frozenset(word for text in self._texts() for word in _words(text))

    def _texts(self) -> Iterator[str]:
        yield from (source.text for source in self._files.of_kind("python-node", "launch-python", "setup-py"))
        yield from (source.text for source in modules(self._files))


def _words(text: str) -> Iterator[str]:
    for statement in _IMPORT.finditer(text):
        yield from _WORD.findall(statement[0])
    for quoted in _TEXT.finditer(text):
        yield quoted[1].rpartition(".")[2]
