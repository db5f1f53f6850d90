"""C++ headers that no file of a tree includes, while it includes others of their folder. What is found there is
information."""

from __future__ import annotations

import os
from functools import cached_property

from bringup_lint.endings import CPP
from bringup_lint.endings import CPP_HEADERS
from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_INCLUDE = regex(r"#[ \t]{0,8}include[ \t]{0,8}([\"<][^\">\n]{1,200}[\">]|[A-Z_]\w{0,80})", hints="include")
"""A name that a macro gives is unknown."""
_OTHERS = (
    ".c",
    ".cu",
    ".cuh",
    ".ino",
    ".mm",
    ".pyx",
    ".pxd",
    ".i",
    ".inc",
    ".tcc",
    ".txx",
    ".impl",
    ".hpp.in",
    ".h.in",
)
"""Other files that include headers of C++: of firmware and CUDA, wrappers and templates."""
_CODE = regex(rf"(?:{'|'.join(each.replace('.', '[.]').replace('+', '[+]') for each in (*CPP, *_OTHERS))})$")
_DEPTH = 100
"""Folders of an include, of which none has more."""
_SIZE = 500_000
"""How much is read of a file."""
_MOST = 5_000
"""C++ files of a tree that is looked through."""


class Unincluded:
    """Asked for a source: whether it is a header that nothing includes."""

    def __init__(self, files: Files) -> None:
        self._files = files

    def has(self, source: Source) -> bool:
        if not source.name.endswith(CPP_HEADERS) or source.origin is not None or self._files.is_configured(source):
            return False
        folder, name = os.path.split(source.absolute)
        beside = self._beside(folder)
        return bool(beside) and name not in beside and name not in self._named.get("", ())

    @memo
    def _beside(self, folder: str) -> frozenset[str]:
        """What includes name of a folder, by however many of its parents."""
        parts = folder.split(os.sep)[-_DEPTH:]
        return frozenset().union(*(self._named.get("/".join(parts[at:]), ()) for at in range(len(parts))))

    @cached_property
    def _named(self) -> dict[str, set[str]]:
        """Folder -> the names in includes; of a path that leads upwards, what follows. Empty where they are not all
        known."""
        tree = self._files.tree
        paths = tree.like(_CODE)
        if len(paths) > _MOST:
            return {}
        found = {name for path in paths for name in _INCLUDE.findall(tree.head(path, _SIZE))}
        if not all(name.endswith(('"', ">")) for name in found):
            return {}
        named: dict[str, set[str]] = {}
        for each in found:
            folder, name = os.path.split(os.path.normpath(each[1:-1]).replace("../", ""))
            named.setdefault(folder, set()).add(name)
        return named
