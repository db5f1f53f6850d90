"""Python files of packages that nothing runs: no console script, installation, launch file or import names them."""

from __future__ import annotations

import os
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
_WORD = regex(r"\w+|(?<=[ \t])\.(?=[.\w \t])")
_TEXT = regex(r"""["']([\w.]{2,80})["']""")
"""What ``importlib`` and the like may be given."""


class Unused:
    def __init__(self, files: Files, workspace: Workspace) -> None:
        self._files = files
        self._workspace = workspace

    def has(self, source: Source) -> bool:
        """Whether a file is in a package whose programs are all known, and is none of them nor a part of one."""
        name = source.basename.removesuffix(".py")
        return self.is_no_program(source) and name not in self._imported and not self._is_beside(source, name)

    def is_no_program(self, source: Source) -> bool:
        """Whether a file is in a package whose programs are all known, and is none of them."""
        owner = self._workspace.owner(source)
        name = source.basename.removesuffix(".py")
        if owner is None or not owner.executables_known or name.startswith("__") or name == source.basename:
            return False
        if not owner.entry_points and not owner.executables:
            return False
        targets = (target.partition(":")[0].rpartition(".")[2] for target in owner.entry_points.values())
        if name in targets or name in self._run:
            return False
        return source.basename not in self._named and not owner.takes(source.absolute)

    def _is_beside(self, source: Source, name: str) -> bool:
        """Whether a file is no part of a Python package, and imported by its name alone."""
        return name in self._imported_alone and os.path.dirname(source.absolute) not in self._folders

    @cached_property
    def _folders(self) -> frozenset[str]:
        return frozenset(os.path.dirname(os.path.abspath(path)) for path in self._files.tree.named("__init__.py"))

    @cached_property
    def _packages(self) -> frozenset[str]:
        return frozenset(map(os.path.basename, self._folders))

    @cached_property
    def _named(self) -> str:
        return "\0".join(source.text for source in self._files.of_kind(*_NAMING))

    @cached_property
    def _run(self) -> frozenset[str]:
        """The last parts of the modules that commands run with ``python3 -m``."""
        return frozenset(match["module"].rpartition(".")[2] for match in _MODULE.finditer(self._named))

    @cached_property
    def _imported(self) -> frozenset[str]:
        """Every word of an import from a Python package of the tree, and of a text that may name a module."""
        quoted = (match[1].rpartition(".")[2] for text in self._texts() for match in _TEXT.finditer(text))
        return frozenset(word for words in self._imports if self._is_own(words) for word in words).union(quoted)

    @cached_property
    def _imported_alone(self) -> frozenset[str]:
        """Every word of another import."""
        return frozenset(word for words in self._imports if not self._is_own(words) for word in words)

    def _is_own(self, words: list[str]) -> bool:
        """Whether an import is relative, or from a Python package of the tree."""
        return words[0] == "." or words[0] in self._packages

    @cached_property
    def _imports(self) -> list[list[str]]:
        """The words of each import; a dot is the first one of a relative import."""
        found = (_WORD.findall(match[0])[1:] for text in self._texts() for match in _IMPORT.finditer(text))
        return [words for words in found if words]

    def _texts(self) -> Iterator[str]:
        yield from (source.text for source in self._files.of_kind("python-node", "launch-python", "setup-py"))
        yield from (source.text for source in modules(self._files))
