"""Callbacks of Python nodes that hand their own node from its executor to the global one."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.callback_code import reached_once
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_self
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_SPINS = {"rclpy.spin_once": 9, "rclpy.spin_until_future_complete": 2}
"""Functions of the global executor, and the position of another one."""
_OWN_EXECUTOR = regex(r"\.\s{0,4}add_node\s{0,4}\(", hints="add_node")
_GLOBAL = regex(r"\brclpy\.spin\s{0,4}\(", hints="spin")
_EXECUTOR_SPINS = regex(r"(?<!\brclpy)\.spin\b", hints="spin")


class Taken(NamedTuple):
    """A call in a callback after which no executor has the node."""

    file: NodeSource
    call: ast.Call
    name: str
    """``rclpy.spin_once``."""
    callback: str
    """In a sentence: ``on_scan()``, ``a lambda``."""


def nested_spins(nodes: Nodes) -> Iterator[Taken]:
    for file, node in nodes.node_classes:
        ending = nodes.ending(file)
        for call, callback in taking_spins(nodes, ending, node).items():
            yield Taken(file, call, str(ending.syntax.qualified(call)), callback)


def taking_spins(nodes: Nodes, ending: Ending, node: NodeClass) -> dict[ast.Call, str]:
    """The calls in the callbacks of a node, each with the callback that runs it.

    The global executor takes a node from the one that it is in, and lets it go at the end (rclpy, ``Node.executor``).
    Where the node is in the global executor already, ``spin_until_future_complete`` leaves it there."""
    found: dict[ast.Call, str] = {}
    if not _has_own_executor(nodes, node):
        return found
    for callback, name, each in reached_once(ending, node, node.callbacks):
        if isinstance(each, ast.Call) and _takes(ending, each):
            found.setdefault(each, name if callback.function is not None else f"{name}()")
    return found


def _has_own_executor(nodes: Nodes, node: NodeClass) -> bool:
    """Whether all programs that make a node add it to an executor of their own."""
    makers = nodes.makers(node)
    return bool(makers) and all(_adds(each.source.text) for each in makers)


def _adds(text: str) -> bool:
    if _GLOBAL.search(text) or not _OWN_EXECUTOR.search(text):
        return False
    return _EXECUTOR_SPINS.search(text) is not None


def _takes(ending: Ending, call: ast.Call) -> bool:
    position = _SPINS.get(ending.syntax.qualified(call) or "")
    if position is None or not call.args or not is_self(call.args[0]):
        return False
    return len(call.args) <= position and all(each.arg in ("timeout_sec", "future") for each in call.keywords)
