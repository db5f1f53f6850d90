"""What the evaluator carries along: the current frame, the conditions it is under, and what it has seen."""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.launch import Action
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.python import PlacedNode
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.budget import STEPS
from bringup_lint.parsers.launch_python.budget import Exhausted
from bringup_lint.parsers.launch_python.objects import Frame
from bringup_lint.parsers.launch_python.objects import Guards
from bringup_lint.parsers.launch_python.objects import Jump
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.source import Span


class Evaluator(NamedTuple):
    """The modules that follow expressions, calls and statements, for all that these lead to."""

    evaluate: Callable[[State, ast.expr], Any]
    condition: Callable[[State, ast.expr], Any]
    call: Callable[[State, Any, list[Any], dict[str, Any], bool, Span], Any]
    run: Callable[[State, list[ast.stmt]], str | None]


@dataclass(eq=False, slots=True)
class State:
    file: LaunchFile
    positions: Positions
    frame: Frame
    evaluator: Evaluator
    guards: Guards = ()
    jumps: list[Jump] = field(default_factory=list)
    """The branches of this round of the loop that have left it."""
    deferred: int = 0
    """Above 0 inside functions that only the run calls."""
    effects: list[Action] = field(default_factory=list)
    """Actions that deferred code performs directly on the launch context."""
    refused: set[int] = field(default_factory=set)
    """Where calls are that launch refuses."""
    lacking: dict[str, tuple[ast.Name, Guards]] = field(default_factory=dict)
    """The first place of each name that no frame has, and the conditions under which that runs."""
    calls: int = 0
    steps: int = STEPS

    def tick(self, cost: int = 1) -> None:
        self.steps -= cost
        if self.steps < 0:
            raise Exhausted

    def evaluate(self, node: ast.expr) -> Any:
        return self.evaluator.evaluate(self, node)

    def condition(self, node: ast.expr) -> Any:
        """An expression of which only the truth counts."""
        return self.evaluator.condition(self, node)

    def call(self, function: Any, positional: list[Any], keywords: dict[str, Any], more: bool, span: Span) -> Any:
        """``more``: further arguments may be passed than are known."""
        return self.evaluator.call(self, function, positional, keywords, more, span)

    def run(self, body: list[ast.stmt]) -> str | None:
        return self.evaluator.run(self, body)

    def span(self, node: PlacedNode) -> Span:
        return self.positions.span(node)

    def unknown(self, why: str, where: PlacedNode | Span) -> Unknown:
        return Unknown(why, where if isinstance(where, Span) else self.positions.span(where))


Builder = Callable[[State, Arguments], Any]
"""What a call of something in the library gives."""


def relative(guards: Guards, base: Guards) -> Guards:
    """The conditions beyond those of an object's own making."""
    if guards[: len(base)] == base:
        return guards[len(base) :]
    return guards
