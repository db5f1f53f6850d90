"""What a package certainly does not install, though parts of its build descriptions are not understood."""

from __future__ import annotations

import os
import re
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.model.package import Build
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree

DESCRIPTIONS = 200
"""Build descriptions of one package that are searched."""
_DESCRIBES = regex(r"(?:CMakeLists\.txt|\.cmake(?:\.in)?|setup\.py|setup\.cfg|pyproject\.toml|package\.xml)\Z")
_FETCHES = regex(r"(?i)\b(?:ExternalProject_Add|FetchContent\w*|file\s*\(\s*DOWNLOAD|urlretrieve|git\s+clone)")
_TAKES_IN = regex(
    r"(?i)\b(?:add_subdirectory[ \t]*\(\s*(?P<folder>[\w./-]+)|include[ \t]*\(\s*(?P<file>[\w./-]+\.cmake)\b)"
)
_NO_PROGRAM = regex(
    r"\.(?:ya?ml|xml|md|rst|txt|urdf|xacro|sdf|srdf|rviz|png|jpe?g|svg|stl|dae|obj|lua)\Z|[._]launch\.(?:py|xml|ya?ml)\Z"
)
DEPTH = 12
"""Folders below a package that are looked into."""


class Absence:
    """One package: its folder and what builds it."""

    def __init__(self, tree: Tree, folder: str, builds: list[Build]) -> None:
        self._tree = tree
        self._folder = folder
        self._builds = builds

    @cached_property
    def _sources(self) -> list[Source]:
        """Everything that may say what is built."""
        below = [path for path in self._tree.walked_below(self._folder) if _DESCRIBES.search(path)]
        sources = (self._tree.read(path, judged=False) for path in below[:DESCRIPTIONS])
        return [source for source in sources if source is not None]

    @cached_property
    def _descriptions(self) -> str:
        return "\n".join(source.text for source in self._sources)

    @cached_property
    def _names(self) -> frozenset[str]:
        """The names of all files below the folder."""
        return frozenset(self._tree.names_below(self._folder, DEPTH))

    @cached_property
    def _stems(self) -> frozenset[str]:
        return frozenset(name.partition(".")[0] for name in self._names)

    @cached_property
    def _programs(self) -> frozenset[str]:
        """The stems of files that a program may be made of: a node and its parameters often have the same name."""
        return frozenset(name.partition(".")[0] for name in self._names if not _NO_PROGRAM.search(name))

    @cached_property
    def _is_open(self) -> bool:
        """Whether the build makes things under names that are written nowhere, or takes them from elsewhere, as where
        only the manifest of a package is in the tree."""
        computed = any(build.names_computed for build in self._builds)
        if computed or not self._builds or not self._descriptions or _FETCHES.search(self._descriptions):
            return True
        return any(self._takes_in_absent(source) for source in self._sources)

    def _takes_in_absent(self, source: Source) -> bool:
        """Whether a CMakeLists.txt takes in a folder or a file that is not in the tree."""
        here = os.path.dirname(source.absolute)
        taken = (match["file"] or f"{match['folder']}/CMakeLists.txt" for match in _TAKES_IN.finditer(source.said))
        return any(not self._tree.exists(os.path.normpath(os.path.join(here, path))) for path in taken)

    def of_executable(self, name: str) -> bool:
        """Whether no file is called so, with whatever ending, and no build description has the word."""
        if self._is_open or name.partition(".")[0] in self._programs:
            return False
        return not self._says(name)

    def of_file(self, path: str) -> bool:
        """Whether nothing below the package, and nothing else of the tree, has the name of a file to be installed."""
        name = os.path.basename(path)
        stem = name.partition(".")[0]
        if not name or self._is_open or stem in self._stems or self._tree.is_ignored(os.path.join(self._folder, path)):
            return False
        return not self._says(stem) and not any(True for _ in self._tree.named(name))

    def _says(self, word: str) -> bool:
        """Whether a build description has a word."""
        return word in self._descriptions and bool(
            re.search(rf"(?<![\w.-]){re.escape(word)}(?![\w-])", self._descriptions)
        )
