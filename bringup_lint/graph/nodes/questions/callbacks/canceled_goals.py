"""Goals that the execute callback of a Python action server ends as canceled where nobody has asked for that."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_ASKS = "is_cancel_requested"
_WORD = "cancel"
_OUTER = (ast.If, ast.While, ast.For, ast.Try, ast.With, ast.Expr)


class CanceledGoal(NamedTuple):
    file: NodeSource
    call: ast.Call
    asked: ast.expr
    """The condition of the branch that ends a goal whose end was asked for."""


def canceled_goals(nodes: Nodes) -> Iterator[CanceledGoal]:
    for file in nodes.robot_sources:
        if _ASKS in file.source.text:
            syntax = nodes.syntax(file)
            for call in syntax.calls:
                if isinstance(call.func, ast.Attribute) and call.func.attr == "canceled":
                    asked = syntax.once(_Goals).asked(call)
                    if asked is not None and not syntax.is_dead(call):
                        yield CanceledGoal(file, call, asked)


class _Goals:
    """How the functions of one file end their goals, each looked through once."""

    def __init__(self, syntax: Syntax) -> None:
        self._syntax = syntax
        self._known: dict[ast.AST | None, set[str]] = {}
        self._branches: dict[tuple[ast.AST | None, str, str], ast.expr | None] = {}

    def asked(self, call: ast.Call) -> ast.expr | None:
        """The condition of a branch beside that of the call, which takes all goals that are to be canceled; None when
        the call may be about such a goal."""
        owner = written(call.func.value) if isinstance(call.func, ast.Attribute) else ""
        function = self._syntax.function(call)
        found, conditions = None, 0
        for outer, name in self._syntax.within(call):
            if not isinstance(outer, _OUTER) or name in ("handlers", "test"):
                return None
            if isinstance(outer, ast.If):
                conditions += 1
                if not _is_plain(outer.test, self._of_others(function)):
                    return None
            found = found or self._branch(outer, name, owner)
        found = found or self._branch(function, "body", owner)
        return found if conditions else None

    def _branch(self, outer: ast.AST | None, name: str, owner: str) -> ast.expr | None:
        """The test of an ``if`` of a block that asks for the cancellation, and whose body leaves the block."""
        key = (outer, name, owner)
        if key not in self._branches:
            block = getattr(outer, name, None)
            tests = (f"{owner}.{_ASKS}", f"{owner}.{_ASKS}()")
            choices = [each for each in block if isinstance(each, ast.If)] if isinstance(block, list) else []
            leaving = (each for each in choices if isinstance(each.body[-1], (ast.Return, ast.Raise)))
            self._branches[key] = next((each.test for each in leaving if written(each.test) in tests), None)
        return self._branches[key]

    def _of_others(self, function: ast.AST | None) -> set[str]:
        """The variables that a function gets from a call, which may have looked for the cancellation."""
        if function not in self._known:
            self._known[function] = set(self._called_for(function))
        return self._known[function]

    def _called_for(self, function: ast.AST | None) -> Iterator[str]:
        for each in own(body_of(function)):
            if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store):
                statement = next(outer for outer, _ in self._syntax.above(each) if isinstance(outer, ast.stmt))
                value = getattr(statement, "value", None) or statement
                if any(isinstance(part, ast.Call) for part in ast.walk(value)):
                    yield each.id


def _is_plain(test: ast.expr, known: set[str]) -> bool:
    """Whether a condition compares what the cancellation does not change: attributes, constants and the goal."""
    if _WORD in written(test).lower():
        return False
    return not any(
        isinstance(each, ast.Call) or (isinstance(each, ast.Name) and each.id in known) for each in ast.walk(test)
    )
