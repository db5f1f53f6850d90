"""Files that a build installs and that are not in the tree."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import is_below
from bringup_lint.graph.workspace import makes_files
from bringup_lint.model.package import Build
from bringup_lint.model.package import Install
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package

_DESCRIPTIONS = frozenset(("package.xml", "CMakeLists.txt", "setup.py", "setup.cfg", "COLCON_IGNORE"))
_NOT_PLAIN = regex(r"[*?\[\]${}~]|^/")
_WORD = regex(r"[\w.-]{1,255}")
_LARGE = regex(
    r"(?:^|/)(?:mesh(?:es)?|models?|weights|media|textures?|videos?|bags?|data)/?$"
    r"|\.(?:png|jpe?g|gif|svg|ico|stl|dae|obj|glb|onnx|pt|pth|engine|blob|bin|hex|elf|so|a|wav|mp3|mp4|pdf|zip|gz|db3|mcap|pgm|pcd)$",
    re.I,
)
"""What is kept apart from the sources of many repositories."""


def missing_files(files: Files, package: Package) -> list[Install]:
    """The files and folders that a build installs in any case, and that neither the tree nor a build makes."""
    found = [*_absent(files, package), *_absent_modules(files.tree, package)]
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


def _absent_modules(tree: Tree, package: Package) -> Iterator[Install]:
    """The first folder of modules of each setup.py that setuptools does not find."""
    if package.manifest.build_type != "ament_python":
        return
    for build in package.builds:
        listed = build.listed_packages
        if listed is None:
            continue
        for name in _found_packages(tree, package) if listed.names is None else listed.names:
            written, where = _folder_of(build, name)
            path = os.path.normpath(os.path.join(package.folder, written))
            if not _NOT_PLAIN.search(written) and _is_untracked(tree, path):
                yield Install("", written, True, where or listed.where, sure=True)
                break


def _found_packages(tree: Tree, package: Package) -> Iterator[str]:
    """What ``find_packages()`` finds beside the setup.py."""
    for path in tree.walked_below(package.folder):
        folder, _, name = os.path.relpath(path, package.folder).rpartition("/")
        if name == "__init__.py" and folder and "/" not in folder and "test" not in folder:
            yield folder


def _folder_of(build: Build, name: str) -> tuple[str, Span | None]:
    """Where setuptools looks for a Python package, and what says so."""
    parts = name.split(".")
    for end in range(len(parts), -1, -1):
        folder = build.package_folders.get(".".join(parts[:end]))
        if folder is not None:
            return "/".join([folder.rstrip("/"), *parts[end:]]), folder.span
    return "/".join(parts), None


def _may_be_made(build: Source, install: Install) -> bool:
    """Whether a name is computed, in a build whose commands may compute the same name to make the file."""
    return "$" in os.path.basename(install.where.text) and makes_files(build)


def _holds_sources(tree: Tree, folder: str) -> bool:
    """Whether a package has more than the description of its build, which a script may copy to its sources."""
    return any(os.path.basename(path) not in _DESCRIPTIONS for path in tree.walked_below(folder))


def _is_absent(tree: Tree, build: Source, written: str, path: str) -> bool:
    name = os.path.basename(path)
    if _NOT_PLAIN.search(written) or not _is_untracked(tree, path):
        return False
    if _LARGE.search(written) and not _has_sisters(tree, path):
        return False
    if not _is_marker(written) and _times(build, name) > 1:
        return False
    return not any(tree.named(f"{name}.in"))


def _times(build: Source, name: str) -> int:
    """How often a build says a name."""
    plain = _WORD.fullmatch(name) is not None
    return build.once(_counts, partial(_counts, build))[name] if plain else build.text.count(name)


def _counts(build: Source) -> Counter[str]:
    """How often a build says each name; what follows a dot may be left out."""
    found: Counter[str] = Counter()
    for match in _WORD.finditer(build.text):
        word = match[0]
        found.update(word[:at] for at, letter in enumerate(word) if letter == ".")
        found[word] += 1
    return found


def _has_sisters(tree: Tree, path: str) -> bool:
    """Whether the folder keeps other files with the same ending."""
    ending = os.path.splitext(path)[1]
    return bool(ending) and any(name.endswith(ending) for name in tree.walked_in(os.path.dirname(path)))


def _is_untracked(tree: Tree, path: str) -> bool:
    """Whether a fresh checkout lacks a file or folder."""
    if tree.exists(path) or tree.is_ignored(path):
        return False
    return not tree.is_link(os.path.dirname(path)) and not is_below(path, tree.submodules)


def _is_marker(written: str) -> bool:
    """The empty file by which ament knows a Python package, called like the package; nothing makes it."""
    return os.path.dirname(written) == "resource"
