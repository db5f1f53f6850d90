"""Files of packages that nothing runs or builds: no console script, installation, launch file or import names a Python
file, and no build description a C++ file."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.endings import CPP_SOURCES
from bringup_lint.graph.modules import modules
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.source import Source

_NAMING = (
    *("systemd-unit", "systemd-dropin", "compose", "dockerfile", "shell-script", "supervisord", "env-file"),
    *(*LAUNCH, "cmake", "setup-py"),
)
"""Kinds of files that start or install others by their names."""
_IMPORT = regex(r"(?m)^[ \t]*(?:from|import)\b[^\n#(]*(?:\([^()]*\))?")
_MODULE = regex(r"[ \t\"']-[A-Za-z]{0,8}m[\"', \t]{1,8}(?P<module>\w[\w.]*)")
_WORD = regex(r"\w+|(?<=[ \t])\.(?=[.\w \t])")
_TEXT = regex(r"""(?<!executable=)(?<!name=)["']([\w.]{2,80})["']""")
"""What ``importlib`` and the like may be given."""
_DEFINES = regex(r"\bclass[ \t]+\w+")
_GATHERS = regex(
    r"(?i)\bGLOB(?:_RECURSE)?\b|\baux_source_directory\b|add_\w{4,20}\s{0,4}\([^()]{0,200}\bDIRECTORY\b"
    r"|\}[\w.-]{0,80}\.c(?:pp|c|xx)\b|\w\}\w"
    r"|\binclude\s{0,4}\(\s{0,4}(?:\$|[\w./-]{1,80}\.cmake)"
)
"""Commands of CMake that may build files which they do not name."""
_NAME = regex(r"\w[\w-]*")
_INCLUDE = regex(r"#[ \t]{0,8}include[ \t]{0,8}[\"<]([^\">\n]{1,200})[\">]", hints="include")
_REMARK = regex(r"#[^\n]*")


class Unused:
    """Whether anything of the tree runs, imports or builds a file."""

    def __init__(self, files: Files, workspace: Workspace) -> None:
        self._files = files
        self._workspace = workspace

    def has(self, source: Source) -> bool:
        """Whether a file is in a package whose programs are all known, and is none of them nor a part of one."""
        if source.basename.endswith(CPP_SOURCES):
            return self._is_unbuilt(source)
        name = source.basename.removesuffix(".py")
        return self.is_no_program(source) and name not in self._imported and not self._is_beside(source, name)

    def _is_unbuilt(self, source: Source) -> bool:
        """Whether CMake builds the package of a C++ source, and nothing names the source, by whatever ending."""
        owner = self._workspace.owner(source)
        builds = [each.source for each in owner.builds if each.source.kind == "cmake"] if owner is not None else []
        stem = source.basename.partition(".")[0]
        if owner is None or not builds or stem.startswith(owner.name) or any(each.matches(_GATHERS) for each in builds):
            return False
        return stem not in self._built and source.basename not in self._included

    @cached_property
    def _built(self) -> frozenset[str]:
        """Every word of the build descriptions of the tree."""
        texts = (_REMARK.sub("", each.text) for each in self._files.of_kind("cmake"))
        return frozenset(word for text in texts for word in _NAME.findall(text))

    @cached_property
    def _included(self) -> frozenset[str]:
        texts = (each.text for each in self._files.of_kind("cpp-node"))
        return frozenset(os.path.basename(match[1]) for text in texts for match in _INCLUDE.finditer(text))

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

    def makes(self, name: str) -> bool:
        """Whether the code of the tree mentions a class other than to define or import it."""
        return name in self._mentioned

    def is_in_others(self, name: str) -> bool:
        """Whether several Python files have a word."""
        return self._files_with[name] > 1

    @cached_property
    def _files_with(self) -> Counter[str]:
        """Word -> how many Python files have it."""
        return Counter(word for text in self._texts() for word in set(_WORD.findall(text)))

    @cached_property
    def _mentioned(self) -> frozenset[str]:
        texts = (*self._texts(), self._named)
        return frozenset(word for text in texts for word in _WORD.findall(_DEFINES.sub("", _IMPORT.sub("", text))))

    @cached_property
    def _imports(self) -> list[list[str]]:
        """The words of each import; a dot is the first one of a relative import."""
        found = (_WORD.findall(match[0])[1:] for text in self._texts() for match in _IMPORT.finditer(text))
        return [words for words in found if words]

    def _texts(self) -> Iterator[str]:
        for source in (*self._files.of_kind("python-node", "launch-python", "setup-py"), *modules(self._files)):
            yield source.uncommented
