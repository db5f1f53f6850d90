"""Loops without an end, in callbacks and in the constructors of nodes."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple


def is_endless(ending: Ending, node: ast.While) -> bool:
    """Whether a ``while True`` or ``while rclpy.ok()`` never ends, and runs no executor."""
    return is_forever(ending.syntax, node) and has_no_exit(node) and not spins(node)


def spins(node: ast.While) -> bool:
    return any("spin" in written(call.func) for call in own_calls(node.body))


def has_no_exit(node: ast.While | ast.For) -> bool:
    """Whether nothing in a loop leaves it, and nothing in it waits for the executor."""
    leaves = (ast.Break, ast.Return, ast.Raise, ast.Await, ast.Yield, ast.YieldFrom)
    exits = [call for call in own_calls(node.body) if isinstance(call.func, ast.Attribute) and call.func.attr == "exit"]
    return not exits and not any(isinstance(each, leaves) for each in own(node.body))


class Endless(NamedTuple):
    """A loop without an end in the constructor of a node."""

    loop: ast.While
    test: str


def endless_constructors(ending: Ending, cls: NodeClass) -> Iterator[Endless]:
    """Loops that keep a node from ever being handed to an executor; none where a thread or the loop runs one."""
    init, text = cls.methods.get("__init__"), ending.file.source.text
    if init is None or "Thread" in text or "multiprocessing" in text:
        return
    if not any("while" in each.source.text for each in cls.lineage):
        return
    for node in reached(ending.syntax, body_of(init.node), cls):
        if isinstance(node, ast.While) and is_endless(ending, node):
            yield Endless(node, written(node.test))


def is_forever(syntax: Syntax, node: ast.While) -> bool:
    """``while True``, ``while 1`` and ``while rclpy.ok()``."""
    if isinstance(node.test, ast.Call):
        return syntax.qualified(node.test) == "rclpy.ok"
    return isinstance(node.test, ast.Constant) and bool(node.test.value)
