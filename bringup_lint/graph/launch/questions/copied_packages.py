"""Packages of other projects of which a copied launch file still asks for files that its own package has."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.facts.ros.released import released
from bringup_lint.graph.launch.packages import is_known_package
from bringup_lint.graph.launch.references import references
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import memo
from bringup_lint.graph.workspace import Found
from bringup_lint.graph.workspace import Package
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch

_COPIED = (*LAUNCH, "urdf")
"""Kinds of file that are copied together."""
_ELSEWHERE = Found(None, None, None)


class CopiedPackage(NamedTuple):
    name: Located
    path: str
    """The file in the package that nobody has, which the own one has, too."""
    owner: Package


def copied_packages(launch: Launch, is_fetched: Callable[[str], bool]) -> Iterator[CopiedPackage]:
    """Each place once, where a launch file that nobody passes anything to asks for such a file other than itself. A
    package that is asked for more than that may be a real one, of another repository.
    ``is_fetched``: whether a list of repositories or a command names a package."""
    known = _Known(launch, is_fetched)
    seen = set()
    found: list[CopiedPackage] = []
    real: set[str] = {name for node in launch.nodes if (name := literal_text(node.package)) is not None}
    for file in launch.judged:
        owner = launch.workspace.owner(file.source)
        if owner is None or file.ros1:
            continue
        for each in references(launch.expansion(file), file, known.find):
            where, name = place(each.value), package_asked(each.value)
            if where is None or name is None or each.optional:
                continue
            path = os.path.join(owner.folder, where.path)
            if where.path and not launch.files.tree.is_file(path):
                real.add(str(name))
            elif where.path and path != file.source.absolute and name.span not in seen:
                seen.add(name.span)
                found.append(CopiedPackage(name, where.path, owner))
    yield from (each for each in found if each.name not in real)


class _Known:
    """The packages that the tree and the tables know, and those that a file of the tree names beside its launch
    files."""

    def __init__(self, launch: Launch, is_fetched: Callable[[str], bool]) -> None:
        self._launch = launch
        self._is_fetched = is_fetched
        depends = {str(name) for package in launch.workspace.packages.values() for _, name in package.manifest.depends}
        self._names = {*launch.workspace.packages, *launch.workspace.ambiguous, *depends, *released()}

    def find(self, value: Value) -> Found | None:
        """Where a path leads that begins in the folder of a package which nothing knows."""
        name = package_asked(value)
        return None if name is None or name in self._names or self._is_named(str(name)) else _ELSEWHERE

    @memo
    def _is_named(self, name: str) -> bool:
        if is_known_package(name) or self._is_fetched(name):
            return True
        others = (source for source in self._launch.files.sources if source.kind not in _COPIED)
        return any(name in source.text for source in others)


def package_asked(value: Value) -> Located | None:
    """The one package in whose share folder a path is."""
    shares = [each for each in walk(value) if isinstance(each, PackageShare)]
    package = shares[0].package if len(shares) == 1 else None
    if not isinstance(package, Literal) or not isinstance(package.value, str):
        return None
    return Located(package.value, package.span)
