"""What the ``from`` imports of a Python file surely take from other files of the tree."""

from __future__ import annotations

import ast
import os
import sys
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import Union

from bringup_lint.facts.ros.needed import base
from bringup_lint.facts.ros.needed import needed
from bringup_lint.graph.memo import kept
from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import bound_names
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.nodes.nodes import Nodes

Definition = Union["ast.FunctionDef", "ast.AsyncFunctionDef", "ast.ClassDef"]
_DEFINITIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
_COMPUTES = regex(
    r"\b(?:globals|exec|setattr|__getattr__)\b|\bsys\.modules\b|\bimport_module\b",
    hints="globals exec setattr __getattr__ sys.modules import_module",
)
"""What may give a module names that it does not write."""


class Taken(NamedTuple):
    """``from module import name``."""

    statement: ast.ImportFrom
    alias: ast.alias
    file: NodeSource
    """The file that the module is."""


class Defined(NamedTuple):
    file: NodeSource
    node: Definition


def taken(nodes: Nodes, file: NodeSource) -> Iterator[Taken]:
    """The names that a file takes from files of which all names are known, where no other module can be meant."""
    for statement in file.nodes:
        if isinstance(statement, ast.ImportFrom):
            found = _file_of(nodes, file, statement)
            if found is not None and found is not file:
                yield from (Taken(statement, each, found) for each in statement.names if each.name != "*")


@memo
def definitions(nodes: Nodes, file: NodeSource) -> dict[str, Defined]:
    """Name in a file -> the function or class of another file that it means, where nothing else of the two files has
    the name."""
    if not any(isinstance(each, ast.ImportFrom) for each in file.nodes):
        return {}
    bound, found = bindings(nodes, file), {}
    for each in taken(nodes, file):
        name = each.alias.asname or each.alias.name
        definition = own_definitions(nodes, each.file).get(each.alias.name) if bound[name] == 1 else None
        if definition is not None:
            found[name] = Defined(each.file, definition)
    return found


@memo
def own_definitions(nodes: Nodes, file: NodeSource) -> dict[str, Definition]:
    """The functions and classes at the top of a file whose names nothing else of it binds."""
    bound = bindings(nodes, file)
    body = file.tree.body if file.tree is not None else []
    return {each.name: each for each in body if isinstance(each, _DEFINITIONS) and bound[each.name] == 1}


@memo
def bindings(nodes: Nodes, file: NodeSource) -> Counter[str]:
    """How often a file binds each name, be it in a function."""
    return Counter(name for each in file.nodes for name in bound_names(each))


def may_fail(syntax: Syntax, statement: ast.stmt) -> bool:
    """Whether an import may fail, or never runs."""
    for outer, name in syntax.above(statement):
        if isinstance(outer, (ast.If, ast.With)) or (isinstance(outer, ast.Try) and name in ("body", "handlers")):
            return True
    return syntax.is_dead(statement)


def _file_of(nodes: Nodes, file: NodeSource, statement: ast.ImportFrom) -> NodeSource | None:
    dotted = "." * statement.level + (statement.module or "")
    if not statement.level and not _is_of_tree(nodes, file, dotted.partition(".")[0]):
        return None
    found = nodes.module_named(dotted, file)
    if found is None or found.tree is None or found.stars or found.source.matches(_COMPUTES):
        return None
    return found


def _is_of_tree(nodes: Nodes, file: NodeSource, top: str) -> bool:
    """Whether a module can only be one of the tree, and that is in one place alone."""
    if top in sys.stdlib_module_names or "sys.path" in file.source.text:
        return False
    here, owner = os.path.dirname(file.source.absolute), nodes.launch.workspace.packages.get(top)
    if owner is None and (top in base() or needed("module", top) is not None):
        return False
    known = _importable(nodes.files.tree)
    folders = [here, *_above(here), *((owner.folder, f"{owner.folder}/src") if owner is not None else ())]
    roots = {each for each in folders if f"{each}/{top}" in known and f"{each}/__init__" not in known}
    return len(roots) == 1


@kept
def _importable(tree: Tree) -> frozenset[str]:
    """The absolute paths of modules without their ending, and of the folders that they are in."""
    found: set[str] = set()
    for path in tree.paths:
        if path.endswith(".py"):
            found.add(path.removesuffix(".py"))
            found.update(_above(path))
    return frozenset(found)


def _above(path: str) -> Iterator[str]:
    while len(path) > 1:
        path = os.path.dirname(path)
        yield path
