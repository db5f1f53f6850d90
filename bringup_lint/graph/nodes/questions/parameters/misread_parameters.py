"""Parameters that a node reads as another type than it declares them with."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.parameter_types import FIELDS
from bringup_lint.graph.nodes.sources.parameter_types import asked
from bringup_lint.graph.nodes.sources.parameter_types import declared_type
from bringup_lint.graph.nodes.sources.parameter_types import may_change
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import Misread
from bringup_lint.model.python import written

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_VALUE = "get_parameter_value"


def misread_parameters(nodes: Nodes) -> Iterator[list[Misread]]:
    """Those of one source together. In Python the field of another type is empty, and in C++ the call throws."""
    for file in nodes.robot_sources:
        if _VALUE not in file.source.text or may_change(nodes.syntax(file)):
            continue
        found = list(_in_file(nodes.syntax(file)))
        if found:
            yield found
    for source in nodes.cpp:
        if source.misread:
            yield source.misread


def _in_file(syntax: Syntax) -> Iterator[Misread]:
    for node in syntax.file.nodes:
        if not isinstance(node, ast.Attribute) or node.attr not in FIELDS or syntax.is_dead(node):
            continue
        name = asked(node.value)
        cls = syntax.class_of(node) if name is not None else None
        declared = cls.parameter(str(name)) if cls is not None else None
        kind = declared_type(syntax, declared)
        if declared is None or kind is None or kind == FIELDS[node.attr] or _asks_type(syntax, node):
            continue
        yield Misread(syntax.file.span_of(node), declared.name, kind, FIELDS[node.attr], node.attr, True)


def _asks_type(syntax: Syntax, node: ast.AST) -> bool:
    """Whether the place is under a condition on a type."""
    outers = (outer for outer, _ in syntax.within(node) if isinstance(outer, (ast.If, ast.IfExp)))
    return any("type" in written(outer.test).lower() for outer in outers)
