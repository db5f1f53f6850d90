"""What the evaluator carries along: the current frame, the conditions it stands under, and what it has seen."""

from __future__ import annotations

import ast
from collections.abc import Callable
from dataclasses import dataclass
from dataclasses import field
from typing import Any

from bringup_lint.model.launch import Action
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python.budget import STEPS
from bringup_lint.parsers.launch_python.budget import Exhausted
from bringup_lint.parsers.launch_python.objects import Frame
from bringup_lint.parsers.launch_python.objects import Guards
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.source import Span


@dataclass(eq=False, slots=True)
class State:
    file: LaunchFile
    positions: Positions
    frame: Frame
    evaluate: Callable[[ast.expr], Any] = None
    call: Callable[..., Any] = None
    """``call(function, positional, keywords, open, span)``; ``open``: more arguments than are known."""
    run: Callable[[list[ast.stmt]], str | None] = None
    guards: Guards = ()
    deferred: int = 0
    """Above 0 inside functions that only the run calls."""
    effects: list[Action] = field(default_factory=list)
    """Actions that deferred code performs directly on the launch context."""
    calls: int = 0
    steps: int = STEPS

    def tick(self, cost: int = 1) -> None:
        self.steps -= cost
        if self.steps < 0:
            raise Exhausted

    def span(self, node: ast.expr | ast.stmt | ast.keyword) -> Span:
        return self.positions.span(node)

    def unknown(self, why: str, where: ast.AST | Span) -> Unknown:
        return Unknown(why, where if isinstance(where, Span) else self.positions.span(where))


def relative(guards: Guards, base: Guards) -> Guards:
    """The conditions beyond those of an object's own making."""
    if guards[: len(base)] == base:
        return guards[len(base) :]
    return guards
