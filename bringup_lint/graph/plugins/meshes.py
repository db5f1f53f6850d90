"""Meshes that robot descriptions name in packages of the tree, and that these do not have."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import is_below
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.spelling import WordSlips

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
_PROPERTY = regex(r"\$\{\s*(\w+)\s*\}")
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
    values = _properties(root)
    for element in root.walk():
        name = element.get("filename") if element.name == "mesh" else None
        filename = _PROPERTY.sub(lambda match: values.get(match[1]) or match[0], name) if name is not None else ""
        match = _PATH.match(filename)
        package = workspace.packages.get(match["scheme"] or match["find"]) if match is not None else None
        if name is None or match is None or package is None:
            continue
        path = os.path.normpath(os.path.join(package.folder, match["rest"]))
        if tree.exists(path) or tree.is_ignored(path) or is_below(path, tree.submodules):
            continue
        if package.folder not in shelves:
            shelves[package.folder] = _Shelf(tree, package)
        like = shelves[package.folder].spelt_otherwise(path)
        if like is not None:
            yield MissingMesh(name, package.name, match["rest"], _is_collision(element), like)


def _properties(root: Element) -> dict[str, str | None]:
    """The properties that a description sets once for all, and None for others."""
    found: dict[str, str | None] = {}
    for each in root.walk():
        if each.name == "xacro:property":
            name = str(each.get("name"))
            found[name] = each.get("value") if name not in found and each.parent is root else None
    return found


def _is_collision(mesh: Element) -> bool:
    outer = mesh.parent.parent if mesh.parent is not None else None
    return outer is not None and outer.name == "collision"


class _Shelf:
    """The meshes that a package has."""

    def __init__(self, tree: Tree, package: Package) -> None:
        self._folder = package.folder
        self._by_path: dict[str, list[str]] = {}
        self._in_folder: dict[str, list[str]] = {}
        self._slips: dict[str, WordSlips] = {}
        for each in tree.walked_below(package.folder):
            if each.lower().endswith(_ENDINGS):
                path = os.path.relpath(os.path.abspath(each), package.folder)
                self._by_path.setdefault(path.lower(), []).append(path)
                self._in_folder.setdefault(os.path.dirname(path), []).append(os.path.basename(path))

    def spelt_otherwise(self, path: str) -> str | None:
        """The one mesh whose path differs in upper and lower case only, or whose name by a letter more or less."""
        inner = os.path.relpath(path, self._folder)
        found = self._by_path.get(inner.lower(), [])
        if found:
            return found[0] if len(found) == 1 else None
        folder, name = os.path.split(inner)
        if folder not in self._slips:
            self._slips[folder] = WordSlips(self._in_folder.get(folder, ()))
        near = self._slips[folder].meant(name)
        return os.path.join(folder, near) if near is not None else None
