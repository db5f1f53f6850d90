"""Results of services that are read before the answer can be there."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import kept
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.python import called_name
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

ASKS = ("call_async", "send_goal_async")
_WAITS = regex(r"sleep|wait|spin|join|acquire|done|execute|recv|get\b")


class EarlyResult(NamedTuple):
    asked: ast.Call
    read: ast.Call
    is_used: bool
    """Something is done with the result."""


def early_results(nodes: Nodes, syntax: Syntax) -> Iterator[EarlyResult]:
    """``future.result()`` after ``call_async`` where nothing in between waits, or asks whether it is done."""
    for call in syntax.calls:
        if not isinstance(call.func, ast.Attribute) or call.func.attr not in ASKS:
            continue
        outer = next(syntax.above(call), None)
        if outer is None:
            continue
        read = _directly(syntax, outer[0]) or _later(syntax, outer[0])
        if read is not None:
            yield EarlyResult(call, read, _is_used(nodes, syntax, read))


def _is_used(nodes: Nodes, syntax: Syntax, read: ast.Call) -> bool:
    """Whether the value of a call is not dropped: at once, or by all that call the function which returns it."""
    outer = next(syntax.above(read))[0]
    if not isinstance(outer, ast.Return):
        return not isinstance(outer, ast.Expr)
    function = syntax.function(outer)
    return function is None or _uses(nodes).get(function.name, True)


@kept
def _uses(nodes: Nodes) -> dict[str, bool]:
    """Name of a function that the robot's code calls -> whether anything takes its value."""
    found: dict[str, bool] = {}
    for file in nodes.robot_code:
        dropped = {id(each.value) for each in file.nodes if isinstance(each, ast.Expr)}
        for each in file.nodes:
            if isinstance(each, ast.Call):
                name = called_name(each)
                found[name] = found.get(name, False) or id(each) not in dropped
    return found


def _directly(syntax: Syntax, outer: ast.AST) -> ast.Call | None:
    """``call_async(...).result()``"""
    if not isinstance(outer, ast.Attribute) or outer.attr != "result":
        return None
    called = next(syntax.above(outer), (None, ""))[0]
    return called if isinstance(called, ast.Call) and called.func is outer else None


def _later(syntax: Syntax, outer: ast.AST) -> ast.Call | None:
    """The result of the future that an assignment keeps, in the plain statements after it."""
    if not isinstance(outer, ast.Assign) or len(outer.targets) != 1:
        return None
    kept = written(outer.targets[0])
    for statement in syntax.after(outer):
        calls = list(own_calls([statement]))
        reads = [each for each in calls if written(each.func) == f"{kept}.result"]
        others = [each for each in calls if each not in reads and _WAITS.search(written(each.func))]
        if others or isinstance(statement, (ast.While, ast.For, ast.Try, ast.With, ast.AsyncWith)):
            return None
        if reads:
            return reads[0]
        if any(isinstance(each, ast.Await) or _is(each, kept) for each in own([statement])):
            return None
    return None


def _is(node: ast.AST, kept: str) -> bool:
    return isinstance(node, (ast.Name, ast.Attribute)) and written(node) == kept
