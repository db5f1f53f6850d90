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
    r"(?:package://(?P<scheme>[\w-]+)|(?:file://)?\$\(find\s+(?P<find>[\w-]+)\s*\))/(?P<rest>[^$]+)(?P<computed>\$.*)?\Z",
    hints="package:// $(find",
)
_ENDINGS = (".stl", ".dae", ".obj", ".glb", ".gltf", ".mesh")


class MissingMesh(NamedTuple):
    where: Located
    package: str
    path: str
    """In the package; only the folder where the name is computed."""
    collides: bool
    """It is the shape by which collisions are found."""
    like: str | None
    """The mesh that is meant: the same name, in other letters or in another folder."""


def missing_meshes(files: Files, workspace: Workspace) -> Iterator[list[MissingMesh]]:
    """Those of one description together. A package that has some of its meshes may be given the large ones in another
    way, and so may another package than that of the description: there, only what is misspelt is missing for sure."""
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
        if name is None or match is None or package is None:
            continue
        if match["computed"] is None and not name.lower().endswith(_ENDINGS):
            continue
        inside = match["rest"] if match["computed"] is None else os.path.dirname(match["rest"])
        path = os.path.normpath(os.path.join(package.folder, inside))
        if tree.exists(path) or tree.is_ignored(path) or is_below(path, tree.submodules):
            continue
        if package.folder not in shelves:
            shelves[package.folder] = _Shelf(tree, package)
        shelf = shelves[package.folder]
        like = shelf.like(path) if match["computed"] is None else None
        folder = path if match["computed"] is not None else os.path.dirname(path)
        if like is not None or (workspace.owner(name.span.source) is package and shelf.lacks_all(folder)):
            yield MissingMesh(name, package.name, inside, _is_collision(element), like)


def _is_collision(mesh: Element) -> bool:
    outer = mesh.parent.parent if mesh.parent is not None else None
    return outer is not None and outer.name == "collision"


class _Shelf:
    """The meshes that a package has."""

    def __init__(self, tree: Tree, package: Package) -> None:
        self._folder = package.folder
        self._folders: set[str] = set()
        self._by_name: dict[str, list[str]] = {}
        for each in tree.walked_below(package.folder):
            path = os.path.relpath(os.path.abspath(each), package.folder)
            self._folders.add(os.path.dirname(path))
            if path.lower().endswith(_ENDINGS):
                self._by_name.setdefault(os.path.basename(path).lower(), []).append(path)

    def lacks_all(self, folder: str) -> bool:
        """Whether the package has no mesh at all, nor anything else in a folder."""
        return not self._by_name and os.path.relpath(folder, self._folder) not in self._folders

    def like(self, path: str) -> str | None:
        """The one mesh of the same name, where only its letters differ, or nothing is in the folder that is named."""
        wanted = os.path.relpath(path, self._folder)
        alike = self._by_name.get(os.path.basename(wanted).lower(), [])
        same = [each for each in alike if each.lower() == wanted.lower()]
        found = same or (alike if os.path.dirname(wanted) not in self._folders else [])
        return found[0] if len(found) == 1 else None
