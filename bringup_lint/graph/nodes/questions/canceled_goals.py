"""Goals that the execute callback of a Python action server ends as canceled where nobody has asked for that."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_ASKS = "is_cancel_requested"
_WORD = "cancel"


class CanceledGoal(NamedTuple):
    file: NodeSource
    call: ast.Call
    asked: ast.expr
    """The condition of the branch that ends a goal whose end was asked for."""


def canceled_goals(nodes: Nodes) -> Iterator[CanceledGoal]:
    for file in nodes.programs:
        if _ASKS in file.source.text:
            syntax = nodes.syntax(file)
            for call in syntax.calls:
                if isinstance(call.func, ast.Attribute) and call.func.attr == "canceled":
                    asked = _asked(syntax, call)
                    if asked is not None and not syntax.is_dead(call):
                        yield CanceledGoal(file, call, asked)


def _asked(syntax: Syntax, call: ast.Call) -> ast.expr | None:
    """The condition of a branch beside that of the call, which takes all goals that are to be canceled; None when the
    call may be about such a goal."""
    owner = ast.unparse(call.func.value) if isinstance(call.func, ast.Attribute) else ""
    known = set(_of_others(syntax, call))
    found, conditions = None, 0
    for outer, name in syntax.within(call):
        if not isinstance(outer, (ast.If, ast.While, ast.For, ast.Try, ast.With, ast.Expr)) or name in (
            "handlers",
            "test",
        ):
            return None
        if isinstance(outer, ast.If):
            conditions += 1
            if not _is_plain(outer.test, known):
                return None
        block = getattr(outer, name)
        found = found or (_branch(block, owner) if isinstance(block, list) else None)
    found = found or _branch(body_of(syntax.function(call)), owner)
    return found if conditions else None


def _branch(block: list[ast.AST], owner: str) -> ast.expr | None:
    """The test of an ``if`` of a block that asks for the cancellation of a goal, and whose body leaves the block."""
    for each in block:
        if isinstance(each, ast.If) and ast.unparse(each.test) in (f"{owner}.{_ASKS}", f"{owner}.{_ASKS}()"):
            if isinstance(each.body[-1], (ast.Return, ast.Raise)):
                return each.test
    return None


def _is_plain(test: ast.expr, known: set[str]) -> bool:
    """Whether a condition compares what the cancellation does not change: attributes, constants and the goal."""
    if _WORD in ast.unparse(test).lower():
        return False
    return not any(
        isinstance(each, ast.Call) or (isinstance(each, ast.Name) and each.id in known) for each in ast.walk(test)
    )


def _of_others(syntax: Syntax, call: ast.Call) -> Iterator[str]:
    """The variables that the function gets from a call, which may have looked for the cancellation."""
    for each in own(body_of(syntax.function(call))):
        if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store):
            statement = next(outer for outer, _ in syntax.above(each) if isinstance(outer, ast.stmt))
            value = getattr(statement, "value", None) or statement
            if any(isinstance(part, ast.Call) for part in ast.walk(value)):
                yield each.id
