"""Python packages inside a package of the workspace that setuptools does not install."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.dependencies.imports import imported
from bringup_lint.model.package import Packages
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Package


class LeftOut(NamedTuple):
    """A module that is needed, in a Python package that is not installed."""

    module: Located
    """As it is imported, or as a console script names it."""
    package: str
    """The Python package with dots."""
    listed: Packages


def left_out(tree: Tree, package: Package) -> Iterator[LeftOut]:
    """What console scripts and installed modules need, each Python package at its first use."""
    found: set[str] = set()
    for build in package.builds:
        listed = build.python_packages
        if listed is None:
            continue
        for module in _needed(tree, package, listed):
            folder = _package_of(tree, package, module)
            if folder and folder not in found and not is_installed(tree, package, listed, folder):
                found.add(folder)
                yield LeftOut(module, folder, listed)


def _needed(tree: Tree, package: Package, listed: Packages) -> Iterator[Located]:
    for script, target in package.entry_points.items():
        yield Located(target.partition(":")[0].strip(), package.executables[script].span)
    for path in tree.walked_below(package.folder):
        if not path.endswith(".py"):
            continue
        own = os.path.relpath(os.path.dirname(os.path.abspath(path)), package.folder).replace(os.sep, ".")
        if own != "." and is_installed(tree, package, listed, own):
            source = tree.at(path)
            yield from imported(source, own) if source is not None else ()


def _package_of(tree: Tree, package: Package, module: str) -> str | None:
    """The Python package of a module of this package of the workspace; None of other modules."""
    parts = module.split(".")
    path = os.path.join(package.folder, *parts)
    if not all(part.isidentifier() for part in parts) or len(parts) < 2:
        return None
    if tree.is_file(f"{path}.py"):
        return ".".join(parts[:-1])
    holds = tree.is_file(os.path.join(path, "__init__.py"))
    return module if holds else None


def is_installed(tree: Tree, package: Package, listed: Packages, name: str) -> bool:
    if listed.names is not None:
        return name in listed.names
    parts = name.split(".")
    folders = (os.path.join(package.folder, *parts[: end + 1]) for end in range(len(parts)))
    return all(tree.is_file(os.path.join(folder, "__init__.py")) for folder in folders)
