"""The C++ files of the packages of the workspace, and the headers that they include."""

from __future__ import annotations

import os
import re
from functools import cached_property
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.endings import CPP_HEADERS
from bringup_lint.graph.memo import memo
from bringup_lint.graph.workspace import Package
from bringup_lint.graph.workspace import Workspace
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_ASIDE = regex(r"/(?:tests?|examples?|build|install|log)/")
_INCLUDE = regex(
    r"^[ \t]*#[ \t]*include[ \t]*[<\"](?!pluginlib/class_list_macros)(?P<package>[\w-]+)/", re.M, hints="include"
)
"""A header of a package; the one with which plugins are exported loads none."""
_LOCAL = regex(r"^[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"\n]+)[>\"]", re.M, hints="include")
_MAIN = regex(r"\bint\s+main\s*\(|\bRCLCPP_COMPONENTS_REGISTER_NODE\b", hints="main RCLCPP_COMPONENTS_REGISTER_NODE")


class CppFiles:
    """Reads each file once."""

    def __init__(self, files: Files, workspace: Workspace) -> None:
        self._files = files
        self._workspace = workspace

    @memo
    def source(self, path: str) -> Source | None:
        """A file of the tree; nobody reads what CMakeLists.txt names outside of it."""
        known, tree = self.known.get(path), self._files.tree
        return known or (tree.read(path, "cpp-node", judged=False) if tree.holds(path) else None)

    @cached_property
    def known(self) -> dict[str, Source]:
        """Those that are looked at in any case, by their paths."""
        return {source.absolute: source for source in self._files.of_kind("cpp-node")}

    def of_package(self, package: Package, endings: tuple[str, ...] = CPP) -> list[str]:
        """The files of a package, without those of tests."""
        paths = self._by_folder.get(package.folder, [])
        return [path for path in paths if path.endswith(endings)]

    @cached_property
    def _by_folder(self) -> dict[str, list[str]]:
        """Folder of a package -> the C++ files in it."""
        folders = {package.folder for package in self._workspace.packages.values()}
        found: dict[str, list[str]] = {}
        for path in self._files.tree.paths:
            if path.endswith(CPP):
                owner = _owner(path, folders)
                if owner is not None and not _ASIDE.search(path[len(owner) :]):
                    found.setdefault(owner, []).append(path)
        return found

    @memo
    def by_stem(self, package: Package) -> dict[str, list[str]]:
        """The files of a package by their names without endings."""
        found: dict[str, list[str]] = {}
        for path in self.of_package(package):
            found.setdefault(stem(path), []).append(path)
        return found

    @memo
    def is_program(self, path: str) -> bool:
        """Whether a file is the main one of a program, or registers a component."""
        source = self.source(path) if not path.endswith(CPP_HEADERS) else None
        return source is not None and source.matches(_MAIN)

    @memo
    def includes(self, path: str) -> list[str]:
        """The headers that a file includes, as it names them."""
        source = self.source(path)
        return _LOCAL.findall(source.text) if source is not None else []


def stem(path: str) -> str:
    return os.path.basename(path).partition(".")[0]


def _owner(path: str, folders: set[str]) -> str | None:
    folder = os.path.dirname(path)
    while folder not in folders:
        above = os.path.dirname(folder)
        if above == folder:
            return None
        folder = above
    return folder


def packages_included(source: Source) -> set[str]:
    """The packages of which a C++ file includes headers."""
    return source.once(packages_included, partial(_packages, source))


def _packages(source: Source) -> set[str]:
    return {each["package"] for each in _INCLUDE.finditer(source.text)}
