"""What a class stores in an attribute of its instances."""

from __future__ import annotations

import ast

from bringup_lint.graph.nodes.questions.message_types import message_type
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeClass


def stored(syntax: Syntax, cls: NodeClass, attribute: ast.expr) -> list[ast.expr | None]:
    """The values but ``None`` that a class gives to an attribute such as ``self.x``; None for one that is unknown."""
    if cls.node is None:
        return []
    name = ast.unparse(attribute)
    found: list[ast.expr | None] = []
    for each in cls.inner:
        if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Store) and ast.unparse(each) == name:
            outer = next(syntax.above(each))[0]
            found.append(outer.value if isinstance(outer, (ast.Assign, ast.AnnAssign)) else None)
    return [each for each in found if not isinstance(each, ast.Constant) or each.value is not None]


def is_message(syntax: Syntax, cls: NodeClass, value: ast.expr | None) -> bool:
    """Whether a value is a new message, or what a subscription of the class gave, or a field of it."""
    if isinstance(value, ast.Call):
        return message_type(syntax.qualified(value)) is not None
    while isinstance(value, ast.Attribute):
        value = value.value
    function = syntax.function(value) if isinstance(value, ast.Name) else None
    taken = {each.callback for each in cls.endpoints if each.role == "subscription"}
    if not isinstance(value, ast.Name) or function is None or function.name not in taken:
        return False
    return value.id in {each.arg for each in function.args.args[1:2]}
