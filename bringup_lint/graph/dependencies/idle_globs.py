"""Globs of a setup.py that match nothing, where files lie that no build installs."""

from __future__ import annotations

import os
from collections.abc import Iterator
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.package import Install

_WILDCARD = regex(r"[*?]|\[[^\]]*\]?")
_ASIDE = regex(r"(?i)^(?:\.|_|readme|license|changelog|todo|cmakelists)|\.(?:md|rst|pyc|bak|orig|swp|in|em)$")
"""Files that nobody means to install."""
_LAUNCH = regex(r"launch\.(?:py|xml|ya?ml)$")
"""Launch files, whose absence is said where they are."""
_ALIKE = (
    *("yaml yml json toml ini cfg lua xml", "urdf xacro sdf srdf world xml", "stl dae obj glb", "hex bin elf uf2 fw"),
    *(
        "png jpg jpeg pgm bmp svg",
        "onnx pt pth tflite pb xml",
        "csv txt json geojson dat",
        "wav mp3 ogg",
        "rviz",
    ),
)
"""Endings of files that are used for the same."""


class IdleGlob(NamedTuple):
    install: Install
    files: tuple[str, ...]
    """The names of the files that it leaves out."""
    folder: str
    """The folder of these, relative to the package."""


def idle_globs(launch: Launch, package: Package) -> Iterator[IdleGlob]:
    """Only where the whole installation of the package is known. Silent of what git ignores: it is made later."""
    if not package.installs_known or package.manifest.build_type != "ament_python":
        return
    for build in package.builds:
        for install in build.installs:
            folder, pattern = os.path.split(install.source)
            if not _WILDCARD.search(pattern) or _WILDCARD.search(folder) or not folder:
                continue
            there = _names(launch, package, folder)
            made = os.path.join(package.folder, folder, _WILDCARD.sub("x", pattern))
            if any(fnmatchcase(name, pattern) for name in there) or launch.files.tree.is_ignored(made):
                continue
            yield from _idle(launch, package, install, there)


def _idle(launch: Launch, package: Package, install: Install, there: list[str]) -> Iterator[IdleGlob]:
    folder, pattern = os.path.split(install.source)
    if not there:
        beside = {folder for folder in map(os.path.dirname, launch.files.tree.walked_below(package.folder))}
        others = sorted(os.path.relpath(each, package.folder) for each in beside)
        folder = next(iter(nearest(folder, others, 2)), "")
        there = [name for name in _names(launch, package, folder) if fnmatchcase(name, pattern)] if folder else []
    left = [name for name in there if _is_alike(name, pattern) and _is_left(launch, package, folder, name)]
    if left and not _is_said(launch, package, folder):
        yield IdleGlob(install, tuple(left), folder)


def _names(launch: Launch, package: Package, folder: str) -> list[str]:
    """The files that lie in a folder of a package."""
    path = os.path.normpath(os.path.join(package.folder, folder))
    below = launch.files.tree.walked_below(path)
    return sorted(os.path.basename(each) for each in below if os.path.dirname(each) == path)


def _is_alike(name: str, pattern: str) -> bool:
    """Whether a file is used for the same as those that a glob means."""
    one, other = name.rpartition(".")[2].lower(), pattern.rpartition(".")[2].lower()
    return one == other or any(one in each.split() and other in each.split() for each in _ALIKE)


def _is_left(launch: Launch, package: Package, folder: str, name: str) -> bool:
    path = os.path.join(package.folder, folder, name)
    is_aside = _ASIDE.search(name) or _LAUNCH.search(name)
    return not is_aside and not package.takes(path) and not launch.files.tree.is_ignored(path)


def _is_said(launch: Launch, package: Package, folder: str) -> bool:
    """Whether a launch file opens a file of a folder that is not installed."""
    references = (each for file in launch.judged for each in launch.references(file))
    lost = (each.found.file for each in references if each.found.package is package and each.found.installed is False)
    return any(path is not None and os.path.dirname(path) == os.path.join(package.folder, folder) for path in lost)
