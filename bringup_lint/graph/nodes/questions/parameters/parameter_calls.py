"""Calls for parameters that rclpy takes in another way than they are meant."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.named_tuple import NamedTuple

_OF_PARAMETER = frozenset(
    ("value", "_value", "name", "type_", "Type", "get_parameter_value", "to_parameter_msg", "from_parameter_msg")
)
"""What ``rclpy.parameter.Parameter`` has, in every distribution."""
_TYPED = ("_value", "as_")
"""How the fields of ParameterValue and the methods of rclcpp are called."""


class EmptyDefault(NamedTuple):
    """``declare_parameter(name, [])``."""

    name: str
    default: ast.List


def empty_defaults(syntax: Syntax) -> Iterator[EmptyDefault]:
    for call in syntax.calls:
        if not _is_method(call, "declare_parameter") or len(call.args) != 2 or call.keywords:
            continue
        name, default = call.args
        if isinstance(name, ast.Constant) and isinstance(default, ast.List) and not default.elts:
            yield EmptyDefault(str(name.value), default)


def untyped_reads(syntax: Syntax) -> Iterator[ast.Attribute]:
    """``get_parameter(name).double_value``: the field of a ParameterValue, which is one call farther."""
    for node in syntax.file.nodes:
        if not isinstance(node, ast.Attribute) or node.attr in _OF_PARAMETER or syntax.is_dead(node):
            continue
        if not node.attr.endswith(_TYPED[0]) and not node.attr.startswith(_TYPED[1]):
            continue
        if isinstance(node.value, ast.Call) and _is_method(node.value, "get_parameter"):
            yield node


def _is_method(call: ast.Call, name: str) -> bool:
    function = call.func
    return isinstance(function, ast.Attribute) and function.attr == name and isinstance(function.value, ast.Name)
