"""Callbacks that wait in the methods of an object whose class is in another file of the workspace."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.callbacks.blocking import Blocking
from bringup_lint.graph.nodes.questions.callbacks.blocking_calls import blocked_by_library
from bringup_lint.graph.nodes.sources.callback_code import reached_once
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import calls_through
from bringup_lint.graph.nodes.sources.syntax import methods_of
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_own
from bringup_lint.model.python import written

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.source import Span

_ROLES = ("subscription", "timer", "service")
_DEPTH = 3


def driver_waits(nodes: Nodes, file: NodeSource, cls: NodeClass) -> Iterator[Blocking]:
    """The first wait of a class that a callback reaches by ``self.driver.method()``."""
    callbacks = [each for each in cls.callbacks if each.role in _ROLES]
    for callback, name, node in reached_once(nodes.ending(file), cls, callbacks):
        found = _wait(nodes, file, cls, callback, name, node)
        if found is not None:
            yield found
            return


def _wait(
    nodes: Nodes, file: NodeSource, cls: NodeClass, callback: Callback, name: str, node: ast.AST
) -> Blocking | None:
    function = node.func if isinstance(node, ast.Call) else None
    if not isinstance(node, ast.Call) or not isinstance(function, ast.Attribute):
        return None
    driver = function.value
    if not is_own(driver):
        return None
    syntax = nodes.syntax(file)
    made = stored(syntax, cls, driver)
    dotted = syntax.qualified(made[0]) if len(made) == 1 and isinstance(made[0], ast.Call) else None
    module, _, class_name = (dotted or "").rpartition(".")
    other = nodes.module_named(module, file) if module else None
    waits = _in_method(nodes, other, class_name, function.attr) if other is not None else None
    if waits is None:
        return None
    what, how_long, where = waits
    return Blocking(callback, name, node, f"{written(function)}()", how_long, where=where, inner=what)


def _in_method(nodes: Nodes, other: NodeSource, class_name: str, method: str) -> tuple[str, str, Span] | None:
    """What the first library call that blocks in a method is, how long it waits, and its place."""
    methods = methods_of(other.tree.body if other.tree is not None else [], class_name) or {}
    ending = nodes.ending(other)
    for call in calls_through(methods, method, _DEPTH, lambda _: False):
        found = blocked_by_library(ending, call)
        if found is not None:
            return found.what, found.how_long, other.span_of(call)
    return None
