"""Callbacks for new values of parameters that read the old ones."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_READS = frozenset({"get_parameter", "get_parameter_or", "get_parameters", "get_parameters_by_prefix"})


class StaleRead(NamedTuple):
    file: NodeSource
    callback: Callback
    read: ast.Call
    function: str


def stale_reads(nodes: Nodes) -> Iterator[StaleRead]:
    """The first parameter that each callback of ``add_on_set_parameters_callback`` asks the node for, if it never looks
    at the values that it is handed."""
    for file, node in nodes.node_classes:
        for callback in node.callbacks:
            read = _read(node, callback) if callback.role == "parameters" else None
            if read is not None and callback.name is not None:
                yield StaleRead(file, callback, read, callback.name)


def _read(node: NodeClass, callback: Callback) -> ast.Call | None:
    method = node.methods.get(callback.name) if callback.name is not None else None
    if method is None or method.decorators or callback.span.text != f"self.{method.name}":
        return None
    body = body_of(method.node)
    handed = [each.arg for each in method.node.args.args[1:]]
    used = {each.id for statement in body for each in walk(statement) if isinstance(each, ast.Name)}
    if len(handed) != 1 or handed[0] in used or any(isinstance(each, ast.Lambda) for each in own(body)):
        return None
    return next((each for each in own_calls(body) if _reads(each)), None)


def _reads(call: ast.Call) -> bool:
    """``self.get_parameter(...)``"""
    function = call.func
    if not isinstance(function, ast.Attribute) or not isinstance(function.value, ast.Name):
        return False
    return function.value.id == "self" and function.attr in _READS
