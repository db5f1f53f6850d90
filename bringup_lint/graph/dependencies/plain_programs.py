"""Programs that a package installs, and that do not say which interpreter they are for."""

from __future__ import annotations

import os
import re
from collections.abc import Container
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.package import Install
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Package

_SCRIPTS = (".py", ".sh", ".bash")
_IS_RUN = regex(r"^if\s{1,4}__name__\s{0,4}==", re.M, "__name__")
_IMPORTS = regex(r"^[ \t]*(?:from|import)[ \t]+\.?(\w+)\b", re.M, "from import")
_OF_ROS = regex(r"\brclcpp", hints="rclcpp")
_LINKS = regex(r"\b(?:CREATE_LINK|create_symlink)\b", hints="CREATE_LINK create_symlink")
_PAGES = regex(
    r"(?:\.(?:cmake|md|rst|txt|sh|bash|service|ya?ml|meta|py|desktop)|(?:^|/)[^/]*(?:Make|Docker|Container|just)file[^/]*)$"
)
_USES_BIN = regex(
    r"(?:\bset\s{0,4}\(\s{0,4}|-D\s{0,4})CMAKE_INSTALL_BINDIR\b|\binstall/(?:[\w.-]{1,80}/)?bin/\w",
    hints="CMAKE_INSTALL_BINDIR install/",
)
"""What gives the programs of CMake another folder, or starts one from ``bin``."""
_READ = 200_000


def plain_programs(tree: Tree, package: Package, started: Container[str]) -> Iterator[Install]:
    """Scripts with the mode of a program in ``lib/<package>``, without ``#!`` at their start. Others than those that
    launch files start may be modules that lie beside a program."""
    for build in package.builds:
        folder = os.path.dirname(build.source.absolute)
        for install in build.installs:
            name = install.renamed or os.path.basename(install.source)
            if install.tree or install.destination.strip("/") != f"lib/{package.name}" or name in build.without_mode:
                continue
            path = os.path.normpath(os.path.join(folder, install.source))
            if not path.endswith(_SCRIPTS) or not tree.is_file(path):
                continue
            text = tree.head(path, _READ)
            if text.strip() and not text.startswith("#!") and (name in started or _IS_RUN.search(text)):
                yield install


def programs_without_mode(tree: Tree, package: Package, started: Container[str]) -> Iterator[Located]:
    """The names of programs in Python that a build installs into ``lib/<package>`` as plain files. One that another
    file of the package imports lies there as a module."""
    imported: set[str] | None = None
    for build in package.builds:
        folder = os.path.dirname(build.source.absolute)
        for name, where in build.without_mode.items():
            path = os.path.normpath(os.path.join(folder, where.replace("${PROJECT_NAME}", package.name)))
            text = tree.head(path, _READ) if name.endswith(".py") and tree.is_file(path) else ""
            if text.startswith("#!") and _IS_RUN.search(text) and name not in started:
                imported = _imported(tree, package) if imported is None else imported
                if name.removesuffix(".py") not in imported:
                    yield Located(name, where.span)


def unplaced_programs(tree: Tree, package: Package, started: Container[str]) -> Iterator[Located]:
    """The nodes in C++ that a build installs into no folder in particular, for which CMake takes ``bin``. None where a
    page of the tree says that they are elsewhere, or meant to be there."""
    found = list(_in_bin(tree, package, started))
    if found and not tree.says(_PAGES, _READ, _USES_BIN):
        yield from found


def _in_bin(tree: Tree, package: Package, started: Container[str]) -> Iterator[Located]:
    for build in package.builds:
        if _LINKS.search(build.source.said):
            continue
        folder = os.path.dirname(build.source.absolute)
        for name, place in build.elsewhere.items():
            is_alone = f"TARGET_FILE:{name}>" in build.source.said
            is_built = name in build.unplaced and name in build.built and not is_alone
            if is_built and name not in package.executables and name not in started:
                sources = (os.path.join(folder, each) for each in build.targets.get(name, ()))
                if any(_OF_ROS.search(tree.head(each, _READ)) for each in sources if tree.is_file(each)):
                    yield place


def _imported(tree: Tree, package: Package) -> set[str]:
    """The first modules of the imports in the heads of a package's files."""
    files = (each for each in tree.walked_below(package.folder) if each.endswith(".py"))
    return {name for each in files for name in _IMPORTS.findall(tree.head(each, _READ))}
