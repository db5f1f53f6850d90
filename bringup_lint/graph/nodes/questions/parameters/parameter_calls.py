"""Calls for parameters that rclpy takes in another way than they are meant."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.python import walk
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
    """``get_parameter(name).double_value``: the field of a ParameterValue, which is one call farther; and
    ``get_parameter(name).value.double_value``, where the value is one of Python."""
    callbacks = {each for call in syntax.calls for each in _handed_over(call)}
    for node in syntax.file.nodes:
        if not isinstance(node, ast.Attribute) or node.attr in _OF_PARAMETER or syntax.is_dead(node):
            continue
        if not node.attr.endswith(_TYPED[0]) and not node.attr.startswith(_TYPED[1]):
            continue
        owner = node.value
        if isinstance(owner, ast.Attribute) and owner.attr == "value":
            owner = owner.value
            if _is_handed(syntax, owner, callbacks):
                yield node
        if isinstance(owner, ast.Call) and _is_method(owner, "get_parameter"):
            yield node


def _handed_over(call: ast.Call) -> Iterator[str]:
    """The name of the method that ``add_on_set_parameters_callback`` is given."""
    if _is_method(call, "add_on_set_parameters_callback") and len(call.args) == 1:
        given = call.args[0]
        if isinstance(given, ast.Attribute):
            yield given.attr


def _is_handed(syntax: Syntax, node: ast.expr, callbacks: set[str]) -> bool:
    """Whether a name is that of each of the parameters that rclpy hands to a callback for new values."""
    function = syntax.function(node) if isinstance(node, ast.Name) and callbacks else None
    if function is None or function.name not in callbacks or not isinstance(node, ast.Name):
        return False
    handed = {each.arg for each in function.args.args[1:]}
    loops = (each for each in walk(function) if isinstance(each, ast.For))
    return any(_name_of(each.target) == node.id and _name_of(each.iter) in handed for each in loops)


def _name_of(node: ast.expr) -> str | None:
    return node.id if isinstance(node, ast.Name) else None


def _is_method(call: ast.Call, name: str) -> bool:
    function = call.func
    return isinstance(function, ast.Attribute) and function.attr == name and isinstance(function.value, ast.Name)
