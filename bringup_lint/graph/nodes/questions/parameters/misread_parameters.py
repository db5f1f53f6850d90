"""Parameters that a node reads as another type than it declares them with."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import Misread
from bringup_lint.model.node_source import Parameter
from bringup_lint.model.node_source import type_of_default
from bringup_lint.model.python import written

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_FIELDS = {"double_value": "double", "integer_value": "integer", "bool_value": "bool", "string_value": "string"}
_VALUE = "get_parameter_value"
_ANY_TYPE = ("dynamic_typing", "automatically_declare_parameters_from_overrides")
"""In a source that says so, a parameter may have another type than that of its default."""


def misread_parameters(nodes: Nodes) -> Iterator[list[Misread]]:
    """Those of one source together. In Python the field of another type is empty, and in C++ the call throws."""
    for file in nodes.robot_sources:
        if _VALUE not in file.source.text or any(word in file.source.text for word in _ANY_TYPE):
            continue
        found = list(_in_file(nodes.syntax(file)))
        if found:
            yield found
    for source in nodes.cpp:
        if source.misread:
            yield source.misread


def _in_file(syntax: Syntax) -> Iterator[Misread]:
    for node in syntax.file.nodes:
        if not isinstance(node, ast.Attribute) or node.attr not in _FIELDS or syntax.is_dead(node):
            continue
        name = _asked(node.value)
        cls = syntax.class_of(node) if name is not None else None
        declared = cls.all_parameters.get(str(name)) if cls is not None else None
        kind = type_of_default(declared.default) if declared is not None and declared.known else None
        if declared is None or kind is None or kind == _FIELDS[node.attr]:
            continue
        if not _is_declared_again(syntax, declared) and not _asks_type(syntax, node):
            yield Misread(syntax.file.span_of(node), declared.name, kind, _FIELDS[node.attr], node.attr, True)


def _is_declared_again(syntax: Syntax, declared: Parameter) -> bool:
    """Whether a source declares the parameter in several places, for example one for each model of a device."""
    calls = (each for each in syntax.calls if isinstance(each.func, ast.Attribute) and each.args)
    declaring = (each.args[0] for each in calls if each.func.attr == "declare_parameter")  # type: ignore[attr-defined]
    return sum(isinstance(each, ast.Constant) and each.value == declared.name for each in declaring) > 1


def _asks_type(syntax: Syntax, node: ast.AST) -> bool:
    """Whether the place is under a condition on a type."""
    outers = (outer for outer, _ in syntax.within(node) if isinstance(outer, (ast.If, ast.IfExp)))
    return any("type" in written(outer.test).lower() for outer in outers)


def _asked(value: ast.expr) -> str | None:
    """The name in ``self.get_parameter("name").get_parameter_value()``."""
    outer = value.func if isinstance(value, ast.Call) else None
    if not isinstance(outer, ast.Attribute) or outer.attr != _VALUE or not isinstance(outer.value, ast.Call):
        return None
    call = outer.value
    if not isinstance(call.func, ast.Attribute) or call.func.attr != "get_parameter" or len(call.args) != 1:
        return None
    if not isinstance(call.func.value, ast.Name) or call.func.value.id != "self":
        return None
    name = call.args[0]
    return name.value if isinstance(name, ast.Constant) and isinstance(name.value, str) else None
