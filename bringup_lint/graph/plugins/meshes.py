"""Meshes that robot descriptions name in packages of the tree, and that these do not have."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import is_below
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Located

_PATH = regex(
    r"(?:package://(?P<scheme>[\w-]+)|(?:file://)?\$\(find\s+(?P<find>[\w-]+)\s*\))/(?P<rest>[^$]+)\Z",
    hints="package:// $(find",
)
_ENDINGS = (".stl", ".dae", ".obj", ".glb", ".gltf", ".mesh")


class MissingMesh(NamedTuple):
    where: Located
    package: str
    path: str
    """In the package."""
    collides: bool
    """It is the shape by which collisions are found."""
    like: str
    """The mesh that is meant."""


def missing_meshes(files: Files, workspace: Workspace) -> Iterator[list[MissingMesh]]:
    """Those of one description together. Meshes are large, and a package may be given them in another way: only what
    is misspelt is missing for sure."""
    shelves: dict[str, _Shelf] = {}
    for source in files.of_kind("urdf"):
        root = parse(source).root if source.judged and not source.template else None
        found = list(_missing(files.tree, workspace, shelves, root)) if root is not None else []
        if found:
            yield found


def _missing(tree: Tree, workspace: Workspace, shelves: dict[str, _Shelf], root: Element) -> Iterator[MissingMesh]:
    for element in root.walk():
        name = element.get("filename") if element.name == "mesh" else None
        match = _PATH.match(name) if name is not None else None
        package = workspace.packages.get(match["scheme"] or match["find"]) if match is not None else None
        if name is None or match is None or package is None or not name.lower().endswith(_ENDINGS):
            continue
        path = os.path.normpath(os.path.join(package.folder, match["rest"]))
        if tree.exists(path) or tree.is_ignored(path) or is_below(path, tree.submodules):
            continue
        if package.folder not in shelves:
            shelves[package.folder] = _Shelf(tree, package)
        like = shelves[package.folder].spelt_otherwise(path)
        if like is not None:
            yield MissingMesh(name, package.name, match["rest"], _is_collision(element), like)


def _is_collision(mesh: Element) -> bool:
    outer = mesh.parent.parent if mesh.parent is not None else None
    return outer is not None and outer.name == "collision"


class _Shelf:
    """The meshes that a package has."""

    def __init__(self, tree: Tree, package: Package) -> None:
        self._folder = package.folder
        self._by_path: dict[str, list[str]] = {}
        for each in tree.walked_below(package.folder):
            if each.lower().endswith(_ENDINGS):
                path = os.path.relpath(os.path.abspath(each), package.folder)
                self._by_path.setdefault(path.lower(), []).append(path)

    def spelt_otherwise(self, path: str) -> str | None:
        """The one mesh whose path differs in upper and lower case only."""
        found = self._by_path.get(os.path.relpath(path, self._folder).lower(), [])
        return found[0] if len(found) == 1 else None
