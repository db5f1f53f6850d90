"""Action servers of Python nodes whose goals ask whether they are to be canceled, which no request can bring about.

rclpy, action/server.py: without a ``cancel_callback`` each request is rejected, and the requests are taken by the
executor that runs ``execute_callback``.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import Function
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_own
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_node.values import argument
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_SERVERS = ("rclpy.action.ActionServer", "rclpy.action.server.ActionServer")
_ASKS = "is_cancel_requested"
_GIVEN_LATER = "register_cancel_callback"
_ELSEWHERE = "handle_accepted_callback"
"""What it names may execute the goal in a thread of its own."""
_OTHER_EXECUTOR = regex(r"\b(?!SingleThreaded|ThreadPool)[A-Z]\w{0,40}Executor\(", hints="Executor(")
_LOOPS = (ast.While, ast.For)


class IgnoredCancel(NamedTuple):
    file: NodeSource
    server: ast.Call
    asked: ast.Attribute
    execute: str
    """The method that executes the goal."""
    is_rejected: bool
    """rclpy rejects the requests; else they wait until the goal has ended."""


def ignored_cancels(nodes: Nodes) -> Iterator[IgnoredCancel]:
    for file in nodes.robot_sources:
        if _ASKS in file.source.text and "ActionServer" in file.source.text:
            syntax = nodes.syntax(file)
            for call in (call for name in _SERVERS for call in syntax.named.get(name, [])):
                yield from _of(nodes, syntax, call)


def _of(nodes: Nodes, syntax: Syntax, call: ast.Call) -> Iterator[IgnoredCancel]:
    given = {each.arg for each in call.keywords}
    executed = argument(call, 3, "execute_callback")
    cls = syntax.class_of(call)
    if None in given or cls is None or not is_own(executed) or syntax.is_dead(call):
        return
    method = cls.methods.get(executed.attr)
    asked = _asked(syntax, cls, method) if method is not None else []
    if method is None or not asked:
        return
    if "cancel_callback" not in given:
        if _GIVEN_LATER not in syntax.file.source.text:
            yield IgnoredCancel(syntax.file, call, asked[0], method.name, True)
        return
    waiting = [each for each in asked if _waits(syntax, cls, each)]
    if waiting and _ELSEWHERE not in given and isinstance(method.node, ast.FunctionDef) and _has_one(nodes, cls):
        yield IgnoredCancel(syntax.file, call, waiting[0], method.name, False)


def _asked(syntax: Syntax, cls: NodeClass, method: Function) -> list[ast.Attribute]:
    """Where the execution of a goal asks whether it is to be canceled."""
    inner = reached(syntax, body_of(method.node), cls)
    return [each for each in inner if isinstance(each, ast.Attribute) and each.attr == _ASKS]


def _waits(syntax: Syntax, cls: NodeClass, asked: ast.Attribute) -> bool:
    """Whether a loop asks that gives nothing back to the executor."""
    function = syntax.function(asked)
    loop = next((outer for outer, _ in syntax.within(asked) if isinstance(outer, _LOOPS)), None)
    if loop is None or not isinstance(function, ast.FunctionDef):
        return False
    if any(isinstance(each, (ast.Yield, ast.YieldFrom)) for each in own(body_of(function))):
        return False
    calls = (each for each in reached(syntax, [loop], cls) if isinstance(each, ast.Call))
    return not any("spin" in called_name(each) for each in calls)


def _has_one(nodes: Nodes, cls: NodeClass) -> bool:
    """Whether one thread of rclpy's own executor runs the callbacks of a node."""
    files = (nodes.file_of(cls), *nodes.makers(cls))
    return nodes.threads(cls) == "one" and not any(each.source.matches(_OTHER_EXECUTOR) for each in files)
