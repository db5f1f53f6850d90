"""Constructors that go on after they failed to make what the node uses."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.late_attributes import is_certain
from bringup_lint.graph.nodes.questions.missing_attributes import family_of
from bringup_lint.graph.nodes.questions.missing_attributes import heirs_of
from bringup_lint.graph.nodes.questions.missing_attributes import own_uses
from bringup_lint.graph.nodes.questions.missing_attributes import set_elsewhere
from bringup_lint.graph.nodes.questions.missing_attributes import set_in_body
from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_EXITS = frozenset({"sys.exit", "os._exit", "exit", "quit"})
_SHUTS_DOWN = ("rclpy.shutdown", "rclpy.try_shutdown")
"""What ends the context: the constructor goes on, and no callback runs any more."""


class HalfMade(NamedTuple):
    """A handler in the constructor that leaves an attribute unset, and a use of it."""

    file: NodeSource
    handler: ast.ExceptHandler
    place: ast.Attribute
    set_at: ast.Attribute
    function: str


def half_made(nodes: Nodes) -> Iterator[HalfMade]:
    foreign = set_elsewhere(nodes)
    heirs = heirs_of(nodes)
    for file, node in nodes.with_callbacks:
        init = node.methods.get("__init__")
        family = family_of(nodes, node, heirs) if init is not None and node.node is not None else None
        if init is None or node.node is None or family is None or len(set(family)) != 1:
            continue
        syntax = nodes.syntax(file)
        known = foreign | set(set_in_body(node.node))
        for statement in init.node.body:
            if isinstance(statement, ast.Try):
                yield from _in_try(file, syntax, node, statement, known)


def _in_try(
    file: NodeSource, syntax: Syntax, node: NodeClass, statement: ast.Try, known: set[str]
) -> Iterator[HalfMade]:
    handler = next((each for each in statement.handlers if not _leaves(syntax, node, each)), None)
    if handler is None:
        return
    texts = {each.value for each in file.nodes if isinstance(each, ast.Constant)}
    for place in _made(statement):
        if place.attr in known or place.attr in texts or not _is_set_here_alone(node, statement, place.attr):
            continue
        use = next(_uses(syntax, node, statement, handler, place.attr), None)
        function = syntax.function(use) if use is not None else None
        if use is not None and function is not None:
            yield HalfMade(file, handler, use, place, function.name)
            return


def _leaves(syntax: Syntax, node: NodeClass, handler: ast.ExceptHandler) -> bool:
    """Whether a handler ends the constructor or the process, itself or in a method or function that it calls."""
    for each in walk(handler):
        if isinstance(each, (ast.Raise, ast.Return, ast.Break, ast.Continue, ast.While, ast.For)):
            return True
        if isinstance(each, ast.Call) and (_exits(syntax, each) or _calls_exit(syntax, node, each)):
            return True
    return False


def _exits(syntax: Syntax, call: ast.Call) -> bool:
    return (syntax.qualified(call) or ast.unparse(call.func)) in _EXITS


def _calls_exit(syntax: Syntax, node: NodeClass, call: ast.Call) -> bool:
    inside = (each for function, _ in called(syntax, call, node) for each in walk(function))
    return any(isinstance(each, ast.Raise) or (isinstance(each, ast.Call) and _exits(syntax, each)) for each in inside)


def _made(statement: ast.Try) -> Iterator[ast.Attribute]:
    """The attributes that a ``try`` sets, the first time each, after a call that may fail."""
    is_risky = False
    for each in statement.body:
        is_risky |= any(isinstance(part, ast.Call) for part in walk(each))
        targets = each.targets if isinstance(each, ast.Assign) else []
        for target in targets:
            if is_risky and isinstance(target, ast.Attribute) and ast.unparse(target.value) == "self":
                yield target


def _is_set_here_alone(node: NodeClass, statement: ast.Try, name: str) -> bool:
    inside = {id(part) for each in statement.body for part in walk(each)}
    stores = (each for each in walk(node.node) if isinstance(each, ast.Attribute)) if node.node is not None else ()
    return all(id(each) in inside for each in stores if each.attr == name and not isinstance(each.ctx, ast.Load))


def _uses(
    syntax: Syntax, node: NodeClass, statement: ast.Try, handler: ast.ExceptHandler, name: str
) -> Iterator[ast.Attribute]:
    """The uses that run each time that their method does, in the constructor after the ``try`` or in a callback."""
    inside = syntax.file.span_of(statement)
    started = {each.name for each in node.callbacks if not inside.start <= each.span.start < inside.end}
    if any(isinstance(each, ast.Call) and syntax.qualified(each) in _SHUTS_DOWN for each in walk(handler)):
        started = set()
    for place in sorted(own_uses(syntax, node), key=lambda each: (each.lineno, each.col_offset)):
        function = syntax.function(place)
        if place.attr != name or function is None or function.name not in {"__init__", *started}:
            continue
        is_after = function.name != "__init__" or place.lineno > (statement.end_lineno or 0)
        if is_after and is_certain(syntax, function, place):
            yield place
