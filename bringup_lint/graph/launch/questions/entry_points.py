"""Console scripts of Python packages, and the modules and functions that they call."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.workspace import Package
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree


class MissingEntry(NamedTuple):
    """A console script that ends before its first line."""

    package: Package
    script: Located
    module: str
    function: str
    """Empty when the whole module is missing, or no function is named."""
    file: Source | None
    """The module, where it exists."""


def missing_entries(tree: Tree, package: Package) -> Iterator[MissingEntry]:
    """The console scripts whose module or function the package does not have; of unknown packages none."""
    for name, target in package.entry_points.items():
        module, _, function = (part.strip() for part in target.partition(":"))
        stem = _stem(tree, package, module)
        if stem is None:
            if _is_without_folder(tree, package, module.partition(".")[0]):
                yield MissingEntry(package, package.executables[name], module, "", None)
            continue
        path = next((each for each in (f"{stem}.py", f"{stem}/__init__.py") if tree.exists(each)), None)
        if ":" not in target and (path is not None or tree.exists(f"{os.path.dirname(stem)}.py")):
            source = tree.beside(package.manifest.source, os.path.relpath(path, package.folder)) if path else None
            if source is None or not _runs_when_imported(source):
                yield MissingEntry(package, package.executables[name], module, "", source)
        elif path is None:
            if not _may_be_made(tree, stem):
                yield MissingEntry(package, package.executables[name], module, "", None)
        else:
            source = tree.beside(package.manifest.source, os.path.relpath(path, package.folder))
            first = function.partition(".")[0]
            if first and source is not None and not _defines(source, first):
                yield MissingEntry(package, package.executables[name], module, function, source)


def _stem(tree: Tree, package: Package, module: str) -> str | None:
    """The path of a module without its ending; None when it is not one of the package's own."""
    top, *inner = module.split(".")
    if not top or not all(part.isidentifier() for part in (top, *inner)):
        return None
    for folder in (package.folder, os.path.join(package.folder, "src")):
        if tree.exists(os.path.join(folder, top, "__init__.py")):
            return os.path.join(folder, top, *inner)
    return None


def _is_without_folder(tree: Tree, package: Package, top: str) -> bool:
    """Whether a script means the Python package that is called like its package of ROS, and ``find_packages`` finds
    others only."""
    listed = [build.python_packages for build in package.builds if build.python_packages is not None]
    if top != package.name or len(listed) != 1 or listed[0].names is not None:
        return False
    places = (os.path.join(package.folder, top), os.path.join(package.folder, "src", top))
    if any(tree.exists(place) or tree.exists(f"{place}.py") or tree.is_ignored(place) for place in places):
        return False
    return any(os.path.basename(path) == "__init__.py" for path in tree.walked_below(package.folder))


def _may_be_made(tree: Tree, stem: str) -> bool:
    """Whether the module is a folder, is compiled, or is made on the machine."""
    endings = (".pyx", ".pyi", ".so", ".pyd", ".c", ".cpp", ".py.in")
    if any(tree.exists(f"{stem}{ending}") for ending in ("", *endings)) or tree.is_ignored(f"{stem}.py"):
        return True
    # A folder that is missing as a whole may be a submodule or a link to another package.
    return tree.is_link(os.path.dirname(stem)) or not tree.exists(os.path.dirname(stem))


def _runs_when_imported(source: Source) -> bool:
    """Whether a module calls anything at its top: it may do its work there, before its import ends."""
    tree = tree_of(source)
    return tree is None or any(isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) for node in tree.body)


def _defines(source: Source, name: str) -> bool:
    """Whether a module has a name at its top, as far as that is known."""
    return source.once((_defines, name), lambda: _binds(source, name))


def _binds(source: Source, name: str) -> bool:
    if re.search(rf"^[ \t]*def[ \t]+{re.escape(name)}[ \t]*\(", source.text, re.M):
        return True
    tree = tree_of(source)
    return tree is None or any(name in names or "*" in names for names in map(_names, ast.walk(tree)))


def _names(node: ast.AST) -> tuple[str, ...]:
    """The names that a statement or an expression may bind; ``*`` when any may be bound."""
    if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
        return ("*",) if node.name == "__getattr__" else (node.name,)
    if isinstance(node, (ast.Import, ast.ImportFrom)):
        return tuple((alias.asname or alias.name).partition(".")[0] for alias in node.names)
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
        return (node.id,)
    if isinstance(node, ast.Name) and node.id in ("globals", "exec", "setattr"):
        return ("*",)
    return ()
