"""Nodes that hand themselves to code which may make endpoints for them unseen."""

from __future__ import annotations

import ast

from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_self

HARMLESS = (
    "rclpy.",
    "tf2_ros.",
    "super",
    "threading.",
    "isinstance",
    "id",
    "print",
    "str",
    "repr",
    "hasattr",
    "getattr",
)
"""What makes no endpoints of its own, or only those that are known."""


def registers_itself(node: NodeClass, file: NodeSource) -> bool:
    """Whether a class gives itself to a function or class that is not known."""
    if node.node is None:
        return True
    for call in node.inner:
        if isinstance(call, ast.Call) and any(is_self(value) for value in _values(call)):
            name = file.qualified(call.func) or ""
            if not name.startswith(HARMLESS):
                return True
    return False


def _values(call: ast.Call) -> list[ast.expr]:
    return [*call.args, *(keyword.value for keyword in call.keywords)]
