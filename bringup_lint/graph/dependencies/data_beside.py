"""Files that Python modules look for beside themselves, and that setuptools leaves in the source."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from bringup_lint.graph.dependencies.imports import imported
from bringup_lint.graph.dependencies.own_paths import OwnPaths
from bringup_lint.graph.dependencies.subpackages import is_installed
from bringup_lint.graph.memo import kept
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.package import Packages
    from bringup_lint.source import Source
    from bringup_lint.source import Span

_LOOKS = regex(r"__file__|\brender_template\b", hints="__file__ render_template")
_PACKS = regex(
    r"package[_-]data|exclude_package_data|setuptools[_-](?:scm|git)|site-packages|\bcmdclass\b|get_path\(",
    hints="package_data package-data setuptools site-packages cmdclass get_path",
)
"""What may install more than modules, in setup.py, setup.cfg and pyproject.toml."""
_SETTINGS = ("setup.py", "setup.cfg", "pyproject.toml")
_WORD = regex(r"[A-Za-z_][\w.-]*")
_GIVING = regex(r"(?:launch|\.ya?ml|\.xml|\.sh|\.bash|\.service|\.env|\.conf|[Dd]ockerfile[^/]*|[Mm]akefile)(?:\.py)?$")
"""Files that start nodes and set them up."""


class Beside(NamedTuple):
    where: Span
    path: str
    """From the folder of the package of ROS."""
    installed: Packages
    """What is installed."""


def data_beside(tree: Tree, package: Package) -> Iterator[Beside]:
    """What the console scripts of a package look for, each file or folder at its first use."""
    if package.manifest.build_type != "ament_python" or _packs(tree, package):
        return
    for build in package.builds:
        if build.python_packages is not None:
            found: set[str] = set()
            for source in _modules(tree, package, build.python_packages):
                for where, path in _looked_for(tree, package, source):
                    if path not in found:
                        found.add(path)
                        yield Beside(where, os.path.relpath(path, package.folder), build.python_packages)


def _packs(tree: Tree, package: Package) -> bool:
    paths = (os.path.join(package.folder, name) for name in _SETTINGS)
    return any(_PACKS.search(tree.head(path, 100_000)) for path in paths if tree.is_file(path))


def _modules(tree: Tree, package: Package, listed: Packages) -> Iterator[Source]:
    """The modules that console scripts name, and what these import of the package, and so on."""
    todo = [target.partition(":")[0].strip() for target in package.entry_points.values()]
    seen = set(todo)
    while todo:
        name = todo.pop(0)
        folder = name.rpartition(".")[0]
        source = tree.at(os.path.join(package.folder, *name.split(".")) + ".py")
        if source is None or not folder or not is_installed(tree, package, listed, folder):
            continue
        yield source
        for module in imported(source, folder):
            for each in (str(module), *_members(source, str(module))):
                if each not in seen:
                    seen.add(each)
                    todo.append(each)


def _members(source: Source, module: str) -> Iterator[str]:
    """What ``from package import module`` may mean."""
    tree = tree_of(source)
    if tree is None:
        return
    for statement in tree.body:
        if isinstance(statement, ast.ImportFrom) and (statement.level or statement.module == module):
            yield from (f"{module}.{alias.name}" for alias in statement.names)


def _looked_for(tree: Tree, package: Package, source: Source) -> Iterator[tuple[Span, str]]:
    """The files and folders of the package that a module names by its own place, with absolute paths."""
    syntax = tree_of(source) if _LOOKS.search(source.text) else None
    if syntax is None:
        return
    paths = OwnPaths(source, syntax)
    positions = Positions(source, byte_order_mark(source))
    named = {path: node for node in reversed(paths.outermost) if (path := paths.value(node)) is not None}
    ordered = sorted(f"{path}/" for path in named)
    parts = {path[:-1] for path, other in pairwise(ordered) if other.startswith(path)}
    for path, node in sorted(named.items(), key=lambda item: item[1].lineno):
        if path in parts or path in paths.asked or not _given(tree).isdisjoint(paths.defaults.get(path, ())):
            continue
        if _is_data(tree, package, source, path):
            yield positions.span(node), path


def _is_data(tree: Tree, package: Package, source: Source, path: str) -> bool:
    """Whether a path is that of a file, or of a folder without modules, of the package."""
    if not path.startswith(f"{package.folder}/") or source.absolute.startswith(f"{path}/") or path.endswith(".py"):
        return False
    if tree.is_file(path):
        return True
    below = list(tree.walked_below(path))
    return bool(below) and not any(each.endswith(".py") for each in below)


@kept
def _given(tree: Tree) -> frozenset[str]:
    """The words of files that start nodes or set them up, parameters, options and variables among them."""
    return frozenset(word for text in tree.pages(_GIVING, 100_000) for word in _WORD.findall(text))
