"""Members that Python files take from enumerations of the tree, which do not have them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.python.missing_attributes import asked_for
from bringup_lint.graph.nodes.questions.python.object_attributes import EXPECTED
from bringup_lint.graph.nodes.questions.python.object_attributes import ObjectAttribute
from bringup_lint.graph.nodes.questions.python.object_attributes import lacking
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.tree_imports import Defined
from bringup_lint.graph.nodes.sources.tree_imports import definitions
from bringup_lint.graph.nodes.sources.tree_imports import own_definitions
from bringup_lint.model.python import bound_names
from bringup_lint.model.python import dotted_name
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_BASES = frozenset({"enum.Enum", "enum.IntEnum"})
_PLAIN = (ast.Assign, ast.AnnAssign, ast.FunctionDef, ast.Expr, ast.Pass)
"""Statements by which a class has all its names."""
_ADDS = regex(
    r"\bsetattr\(\s{0,40}(?!\s|self\b)|\bextend_enum\b|\b_member_map_\b", hints="setattr extend_enum _member_map_"
)
"""What may give an enumeration members of any name."""
_OF_INTEGERS = frozenset(dir(int))


def enum_members(nodes: Nodes) -> Iterator[ObjectAttribute]:
    """The first use of each member that an enumeration lacks in a file."""
    for file in nodes.robot_code:
        known = _enumerations(nodes, file)
        places = [(each, _owner(each)) for each in file.nodes if known and isinstance(each, ast.Attribute)]
        seen = {(name, each.attr) for each, name in places if not isinstance(each.ctx, ast.Load)}
        syntax = nodes.syntax(file)
        for place, name in places:
            if name not in known or (name, place.attr) in seen or place.attr.startswith("_"):
                continue
            defined, names = known[name]
            if place.attr in names or place.attr in asked_for(file):
                continue
            if not syntax.is_dead(place) and not syntax.catches(place, EXPECTED):
                seen.add((name, place.attr))
                yield lacking(file, syntax, place, defined)


def _owner(node: ast.Attribute) -> str:
    """The name of what an attribute is taken from; empty for other expressions."""
    return node.value.id if isinstance(node.value, ast.Name) else ""


def _enumerations(nodes: Nodes, file: NodeSource) -> dict[str, tuple[Defined, frozenset[str]]]:
    """Name in a file -> the enumeration that it means, with all names that this has."""
    if file.source.matches(_ADDS):
        return {}
    own = {name: Defined(file, node) for name, node in own_definitions(nodes, file).items()}
    found = {}
    for name, defined in {**definitions(nodes, file), **own}.items():
        members = _members(defined) if not defined.file.source.matches(_ADDS) else None
        if members is not None:
            found[name] = (defined, members)
    return found


def _members(defined: Defined) -> frozenset[str] | None:
    """The names that an enumeration has; None for a class that is none, or whose names are not all known."""
    node, imports = defined.node, defined.file.imports
    if not isinstance(node, ast.ClassDef) or len(node.bases) != 1 or node.keywords:
        return None
    base = dotted_name(node.bases[0])
    base = imports.get(base) or base
    decorators = {each.id if isinstance(each, ast.Name) else "?" for each in node.decorator_list}
    if base not in _BASES or decorators - {"unique"} or not all(isinstance(each, _PLAIN) for each in node.body):
        return None
    names = frozenset(name for each in own(node.body) for name in bound_names(each))
    return names | _OF_INTEGERS if base == "enum.IntEnum" else names | {"mro"}
