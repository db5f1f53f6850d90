"""When a node publishes: only while it starts, or also later."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_own
from bringup_lint.model.python import written
from bringup_lint.source import Span


def published_at_start(file: NodeSource, node: NodeClass, endpoint: Endpoint) -> list[Span]:
    """Where a publisher is used, when this happens only in the constructor and what only the constructor calls, in no
    loop; empty when it may publish later, or when that is not known."""
    attribute = endpoint.attribute or ""
    if not attribute.startswith("self.") or node.node is None or len(list(node.lineage)) > 1:
        return []
    found = list(_calls(node, attribute))
    every = sum(1 for each in ast.walk(node.node) if _is_attribute(each, attribute))
    early = _only_at_start(node)
    if not found or every != len(found) + 1 or any(method not in early or looped for method, looped, _ in found):
        return []
    return [file.span_of(call) for _, _, call in found]


def _calls(node: NodeClass, attribute: str) -> Iterator[tuple[str, bool, ast.Call]]:
    """The calls of ``publish``: in which method, whether in a loop or nested function, and the call."""
    for name, method in node.methods.items():
        loose: set[ast.AST] = set()
        for each in ast.walk(method.node):
            nested = isinstance(each, (ast.For, ast.While, ast.FunctionDef, ast.Lambda)) and each is not method.node
            if nested:
                loose.update(ast.walk(each))
        for call in ast.walk(method.node):
            if isinstance(call, ast.Call) and isinstance(call.func, ast.Attribute) and call.func.attr == "publish":
                if _is_attribute(call.func.value, attribute):
                    yield name, call in loose, call


def _is_attribute(value: ast.AST, attribute: str) -> bool:
    return isinstance(value, ast.Attribute) and written(value) == attribute


def _only_at_start(node: NodeClass) -> set[str]:
    """``__init__``, and the methods of which the only mention is a call in ``__init__``."""
    mentions: dict[str, list[tuple[str, bool]]] = {}
    for name, method in node.methods.items():
        called = {each.func for each in ast.walk(method.node) if isinstance(each, ast.Call)}
        for each in ast.walk(method.node):
            if is_own(each):
                mentions.setdefault(each.attr, []).append((name, each in called))
    return {"__init__"} | {
        name
        for name in node.methods
        if mentions.get(name) and all(place == ("__init__", True) for place in mentions[name])
    }
