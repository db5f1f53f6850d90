"""Constructors that go on after they failed to make what the node uses."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.python.late_attributes import is_certain
from bringup_lint.graph.nodes.questions.python.missing_attributes import family_of
from bringup_lint.graph.nodes.questions.python.missing_attributes import heirs_of
from bringup_lint.graph.nodes.questions.python.missing_attributes import own_uses
from bringup_lint.graph.nodes.questions.python.missing_attributes import set_in_body
from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_EXITS = frozenset({"sys.exit", "os._exit", "exit", "quit"})
_SHUTS_DOWN = frozenset({"shutdown", "try_shutdown", "destroy_node"})
"""What ends the context or the node: the constructor goes on, and no callback runs any more."""


class HalfMade(NamedTuple):
    """A handler in the constructor that leaves an attribute unset, and a use of it."""

    file: NodeSource
    handler: ast.ExceptHandler
    place: ast.Attribute
    set_at: ast.Attribute
    function: str
    ends: bool
    """The handler shuts the context down, to end the program, as the use then does."""


def half_made(nodes: Nodes) -> Iterator[HalfMade]:
    foreign = nodes.set_elsewhere
    heirs = heirs_of(nodes)
    for file, node in nodes.node_classes:
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
    ends = any(_shuts_down(each) for each in reached(syntax, [*handler.body], node))
    texts = {each.value for each in file.nodes if isinstance(each, ast.Constant)}
    for place in _made(statement):
        if place.attr in known or place.attr in texts or not _is_set_here_alone(node, statement, place.attr):
            continue
        use = next(_uses(syntax, node, statement, ends, place.attr), None)
        function = syntax.function(use) if use is not None else None
        if use is not None and function is not None:
            yield HalfMade(file, handler, use, place, function.name, ends)
            return


def _leaves(syntax: Syntax, node: NodeClass, handler: ast.ExceptHandler) -> bool:
    """Whether a handler ends the constructor or the process, itself or in a method or function that it calls."""
    if any(isinstance(each, (ast.Return, ast.Break, ast.Continue, ast.While, ast.For)) for each in walk(handler)):
        return True
    return any(isinstance(each, ast.Raise) or _exits(syntax, each) for each in reached(syntax, [*handler.body], node))


def _exits(syntax: Syntax, node: ast.AST) -> bool:
    return isinstance(node, ast.Call) and (syntax.qualified(node) or written(node.func)) in _EXITS


def _shuts_down(node: ast.AST) -> bool:
    function = node.func if isinstance(node, ast.Call) else None
    name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", None)
    return name in _SHUTS_DOWN


def _made(statement: ast.Try) -> Iterator[ast.Attribute]:
    """The attributes that a ``try`` sets, the first time each, after a call that may fail."""
    is_risky = False
    for each in statement.body:
        is_risky |= any(isinstance(part, ast.Call) for part in walk(each))
        targets = each.targets if isinstance(each, ast.Assign) else []
        for target in targets:
            if is_risky and isinstance(target, ast.Attribute) and written(target.value) == "self":
                yield target


def _is_set_here_alone(node: NodeClass, statement: ast.Try, name: str) -> bool:
    inside = {id(part) for each in statement.body for part in walk(each)}
    stores = (each for each in node.inner if isinstance(each, ast.Attribute))
    return all(id(each) in inside for each in stores if each.attr == name and not isinstance(each.ctx, ast.Load))


def _uses(syntax: Syntax, node: NodeClass, statement: ast.Try, ends: bool, name: str) -> Iterator[ast.Attribute]:
    """The uses that run each time that their method does, in the constructor after the ``try`` or in a callback."""
    started = set() if ends else set(_started(syntax, node, statement))
    for place in sorted(own_uses(syntax, node), key=lambda each: (each.lineno, each.col_offset)):
        function = syntax.function(place)
        if place.attr != name or function is None or function.name not in {"__init__", *started}:
            continue
        is_after = function.name != "__init__" or place.lineno > (statement.end_lineno or 0)
        if is_after and is_certain(syntax, function, place):
            yield place


def _started(syntax: Syntax, node: NodeClass, statement: ast.Try) -> Iterator[str]:
    """The callbacks that the constructor starts in any case: under no condition, and before it may return."""
    for each in node.methods["__init__"].node.body:
        if each.lineno > statement.lineno and any(isinstance(part, ast.Return) for part in walk(each)):
            return
        if isinstance(each, (ast.Expr, ast.Assign, ast.AnnAssign)):
            place = syntax.file.span_of(each)
            made = (callback for callback in node.callbacks if place.start <= callback.span.start < place.end)
            yield from (callback.name for callback in made if callback.name is not None)
