"""Files that a build installs and that are not in the tree."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import is_below
from bringup_lint.graph.workspace import makes_files
from bringup_lint.model.package import Install
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package

_DESCRIPTIONS = frozenset(("package.xml", "CMakeLists.txt", "setup.py", "setup.cfg", "COLCON_IGNORE"))
_NOT_PLAIN = regex(r"[*?\[\]${}~]|^/")
_LARGE = regex(
    r"(?:^|/)(?:mesh(?:es)?|models?|weights|media|textures?|videos?|bags?|data)/?$"
    r"|\.(?:png|jpe?g|gif|svg|ico|stl|dae|obj|glb|onnx|pt|pth|engine|blob|bin|hex|elf|so|a|wav|mp3|mp4|pdf|zip|gz|db3|mcap|pgm|pcd)$",
    re.I,
)
"""What is kept apart from the sources of many repositories."""


def missing_files(files: Files, package: Package) -> list[Install]:
    """The files and folders that a build installs in any case, and that neither the tree nor a build makes."""
    found = list(_absent(files, package))
    return found if found and _holds_sources(files.tree, package.folder) else []


def _absent(files: Files, package: Package) -> Iterator[Install]:
    for build in package.builds:
        folder = os.path.dirname(build.source.absolute)
        for install in build.installs:
            path = os.path.normpath(os.path.join(folder, install.source))
            if not install.sure or _may_be_made(build.source, install):
                continue
            if _is_absent(files.tree, build.source, install.source, path):
                yield install


def _may_be_made(build: Source, install: Install) -> bool:
    """Whether a name is computed, in a build whose commands may compute the same name to make the file."""
    return "$" in os.path.basename(install.where.text) and makes_files(build)


def _holds_sources(tree: Tree, folder: str) -> bool:
    """Whether a package has more than the description of its build, which a script may copy to its sources."""
    return any(os.path.basename(path) not in _DESCRIPTIONS for path in tree.walked_below(folder))


def _is_absent(tree: Tree, build: Source, written: str, path: str) -> bool:
    name = os.path.basename(path)
    if _NOT_PLAIN.search(written) or _LARGE.search(written) or tree.exists(path) or tree.is_ignored(path):
        return False
    if not _is_marker(written) and len(re.findall(rf"(?<![\w.-]){re.escape(name)}(?![\w-])", build.text)) > 1:
        return False
    if any(tree.named(f"{name}.in")):
        return False
    return not tree.is_link(os.path.dirname(path)) and not is_below(path, tree.submodules)


def _is_marker(written: str) -> bool:
    """The empty file by which ament knows a Python package, called like the package; nothing makes it."""
    return os.path.dirname(written) == "resource"
