"""What a class stores in an attribute of its instances."""

from __future__ import annotations

import ast

from bringup_lint.graph.nodes.sources.message_types import message_type
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import written


def stored(syntax: Syntax, cls: NodeClass, attribute: ast.expr) -> list[ast.expr | None]:
    """The values but ``None`` that a class gives to an attribute such as ``self.x``; None for one that is unknown."""
    return syntax.once(_Stored).of(syntax, cls).get(written(attribute), []) if cls.node is not None else []


def module_values(syntax: Syntax) -> dict[str, list[ast.expr | None]]:
    """Name of a variable of the module -> the values that the module gives it."""
    return syntax.once(_of_module)


def _of_module(syntax: Syntax) -> dict[str, list[ast.expr | None]]:
    found: dict[str, list[ast.expr | None]] = {}
    for node in syntax.file.nodes:
        if isinstance(node, ast.Assign) and syntax.function(node) is None:
            for target in node.targets:
                found.setdefault(written(target), []).append(node.value)
    return found


class _Stored:
    """What the classes of one file store, each looked through once. It does not keep the syntax, which keeps it: both
    would wait for a search for garbage."""

    def __init__(self, _: Syntax) -> None:
        self._values: dict[NodeClass, dict[str, list[ast.expr | None]]] = {}

    def of(self, syntax: Syntax, cls: NodeClass) -> dict[str, list[ast.expr | None]]:
        """Attribute, as it is written -> its values but ``None``."""
        if cls not in self._values:
            found: dict[str, list[ast.expr | None]] = {}
            for each in cls.inner:
                if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Store):
                    outer = next(syntax.above(each))[0]
                    value = outer.value if isinstance(outer, (ast.Assign, ast.AnnAssign)) else None
                    if not isinstance(value, ast.Constant) or value.value is not None:
                        found.setdefault(written(each), []).append(value)
            found.pop("", None)
            self._values[cls] = found
        return self._values[cls]


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
