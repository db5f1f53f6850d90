"""Callbacks that do not take what their caller hands over, or do not give back what it needs."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.endless_loops import is_forever
from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import Function
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import children
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource
    from bringup_lint.source import Span


_CALLED = regex(r"self\.(?P<name>\w+)\(.*\)\Z")
_TAKEN = {"subscription": ((1, 2), "the message"), "service": ((2, 2), "the request and the response")}
"""Role -> how few and how many arguments rclpy hands over (subscription.py: a second one is the MessageInfo)."""
_WITHOUT_TIMER_INFO = ("foxy", "galactic", "humble", "iron", "jazzy")
"""Releases whose timers hand nothing over. Source: rclpy, executors.py, ``_take_timer``."""
_ANSWERS = {"service": "the response", "parameters": "a SetParametersResult"}
_ENDS = frozenset({"succeed", "abort"})
_CANCELED = "canceled"


class UnfitCallback(NamedTuple):
    file: NodeSource
    node: NodeClass
    callback: Callback
    place: Span
    """What is wrong there."""
    what: str
    """``called``, ``arguments``, ``answer``, ``goal`` or ``reached``: a goal that is ended only when it is canceled."""
    name: str
    detail: str
    """What the caller hands over, or needs."""


def unfit_callbacks(nodes: Nodes) -> Iterator[UnfitCallback]:
    """Each callback once, whatever else it is registered for."""
    overridden = _overridden(nodes)
    for file, node in nodes.node_classes:
        seen: set[tuple[str, str]] = set()
        for callback in node.callbacks:
            for found in _unfit(nodes, file, node, callback):
                key = (found.what, found.name)
                if key not in seen and (node, found.name) not in overridden:
                    seen.add(key)
                    yield found


def _overridden(nodes: Nodes) -> set[tuple[NodeClass, str]]:
    """The methods that a class which builds on another one defines anew."""
    return {
        (base, name)
        for file in nodes.sources
        for heir in file.classes
        for base in heir.lineage
        if base is not heir
        for name in heir.methods
    }


def _unfit(nodes: Nodes, file: NodeSource, node: NodeClass, callback: Callback) -> Iterator[UnfitCallback]:
    text = callback.span.text
    match = _CALLED.match(text)
    if match is not None and callback.role in ("timer", "subscription", "service"):
        method = node.method(match["name"])
        if method is not None and _gives_nothing(method):
            yield UnfitCallback(file, node, callback, callback.span, "called", match["name"], "")
        return
    method = node.methods.get(callback.name) if callback.name is not None and text == f"self.{callback.name}" else None
    if method is None or method.decorators or _is_stub(method.node):
        return
    taken = _taken(nodes, node, callback)
    if taken is not None and not _takes(method.node, *taken[0]):
        yield UnfitCallback(file, node, callback, method.name.span, "arguments", method.name, taken[1])
    answer = _ANSWERS.get(callback.role)
    if answer is not None and _gives_nothing(method):
        yield UnfitCallback(file, node, callback, method.name.span, "answer", method.name, answer)
    what = _left_open(nodes.syntax(file), node, method.node) if callback.role == "action" else None
    if what is not None:
        yield UnfitCallback(file, node, callback, method.name.span, what, method.name, "")


def _taken(nodes: Nodes, node: NodeClass, callback: Callback) -> tuple[tuple[int, int], str] | None:
    """How few and how many arguments the caller hands over, and what they are."""
    if callback.role == "timer":
        return ((0, 0), "nothing") if nodes.files.target.ros in _WITHOUT_TIMER_INFO else None
    if callback.role == "subscription" and not any(_is_within(callback, each.span) for each in node.endpoints):
        return None
    return _TAKEN.get(callback.role)


def _is_within(callback: Callback, span: Span) -> bool:
    return span.start <= callback.span.start and callback.span.end <= span.end


def _takes(method: FunctionNode, fewest: int, most: int) -> bool:
    """Whether a method takes some number of arguments after ``self`` that the caller may hand over."""
    arguments = method.args
    positional = len(arguments.posonlyargs) + len(arguments.args) - 1
    needed = positional - len(arguments.defaults)
    if positional < 0 or any(default is None for default in arguments.kw_defaults):
        return True
    return needed <= most and (arguments.vararg is not None or positional >= fewest)


def _gives_nothing(function: Function) -> bool:
    """Whether no path through a function gives a value back."""
    inner = list(own(body_of(function.node)))
    if function.decorators or _is_stub(function.node):
        return False
    if any(isinstance(each, (ast.Yield, ast.YieldFrom)) for each in inner):
        return False
    returned = (each.value for each in inner if isinstance(each, ast.Return))
    return all(value is None or _is_none(value) for value in returned)


def _is_none(value: ast.expr) -> bool:
    return isinstance(value, ast.Constant) and value.value is None


def _is_stub(method: FunctionNode) -> bool:
    """Whether a method only says what another class is to do, or always raises."""
    body = [each for each in method.body if not (isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant))]
    return all(isinstance(each, ast.Pass) for each in body) or isinstance(body[-1], ast.Raise)


def _left_open(syntax: Syntax, node: NodeClass, method: FunctionNode) -> str | None:
    """Which goals (``goal``: all, ``reached``: those that nobody cancels) a method executes and never ends; None where
    it hands its handle to somebody else."""
    names = [each.arg for each in method.args.args]
    if len(names) != 2:
        return None
    handle = names[1]
    for each in walk(method):
        if isinstance(each, ast.Name) and each.id == handle and not _is_asked(syntax, each):
            return None
    inner = (*walk(method), *reached(syntax, body_of(method), node))
    called = {each.attr for each in inner if isinstance(each, ast.Attribute)}
    if called & _ENDS:
        return None
    if _CANCELED not in called:
        return "goal"
    return "reached" if _ends_uncanceled(syntax, method) else None


def _ends_uncanceled(syntax: Syntax, method: FunctionNode) -> bool:
    """Whether a method comes to its last ``return`` without a call of ``canceled()`` before it, other than in a branch
    that leaves the method."""
    *before, last = method.body
    return isinstance(last, ast.Return) and not _may_cancel(before) and not any(_stays(syntax, each) for each in before)


def _stays(syntax: Syntax, statement: ast.stmt) -> bool:
    """Whether nothing after a statement is reached as long as the program runs."""
    if isinstance(statement, ast.While):
        return is_forever(syntax, statement) and not _has_own_break(statement)
    return isinstance(statement, ast.Raise)


def _has_own_break(loop: ast.While) -> bool:
    inner: list[ast.AST] = list(loop.body)
    for each in inner:
        if isinstance(each, ast.Break):
            return True
        if not isinstance(each, (ast.For, ast.AsyncFor, ast.While, *FUNCTIONS, ast.ClassDef)):
            inner += children(each)
    return False


def _may_cancel(statements: list[ast.stmt]) -> bool:
    """Whether the method may go on after a call of ``canceled()`` in statements of it."""
    inner = list(statements)
    for each in inner:
        if isinstance(each, (ast.If, ast.For, ast.While)):
            blocks = [block for block in (each.body, each.orelse) if block]
            inner += [one for block in blocks if not isinstance(block[-1], (ast.Return, ast.Raise)) for one in block]
        elif any(getattr(one, "attr", None) == _CANCELED for one in walk(each)):
            return True
    return False


def _is_asked(syntax: Syntax, name: ast.Name) -> bool:
    """Whether a name is only the object of ``name.attribute``."""
    outer = next((outer for outer, _ in syntax.above(name)), None)
    return isinstance(outer, ast.Attribute)
