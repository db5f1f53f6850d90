"""Timers that send PX4 the signal for offboard control too rarely."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.nodes.sources.syntax import Syntax
    from bringup_lint.model.node_source import NodeClass
    from bringup_lint.model.node_source import NodeSource
    from bringup_lint.model.node_source import Timer

LONGEST = 0.5
"""Seconds between two signals: PX4 wants more than two a second (PX4 guide, "Offboard Mode")."""
_SIGNAL = "px4_msgs/msg/OffboardControlMode"


_RESET = "timer_period_ns"
"""What gives a timer another period."""


class RareSignal(NamedTuple):
    file: NodeSource
    timer: Timer
    period: float
    sent: ast.Call


def rare_signals(nodes: Nodes) -> Iterator[RareSignal]:
    """The signals of nodes that a single timer sends, and nothing else."""
    published: dict[int, dict[str | None, list[ast.Call]]] = {}
    for file, node in nodes.node_classes:
        kept = [each.attribute for each in node.all_endpoints if each.role == "publisher" and each.type == _SIGNAL]
        if len(kept) != 1:
            continue
        syntax = nodes.syntax(file)
        if id(file) not in published:
            published[id(file)] = _published(syntax)
        sent = published[id(file)].get(kept[0], [])
        functions = {function for call in sent if (function := syntax.function(call)) is not None}
        if not sent or _RESET in file.source.text or _named(node, kept) > len(sent) or any(map(_repeats, functions)):
            continue
        timer = _only_timer(node, functions.pop().name) if len(functions) == 1 else None
        if timer is not None and timer.period is not None and timer.period > LONGEST:
            yield RareSignal(file, timer, timer.period, sent[0])


def _published(syntax: Syntax) -> dict[str | None, list[ast.Call]]:
    """Publisher -> the calls of a file that publish by it."""
    found: dict[str | None, list[ast.Call]] = {}
    for call in syntax.calls:
        if isinstance(call.func, ast.Attribute) and call.func.attr == "publish":
            found.setdefault(written(call.func.value), []).append(call)
    return found


def _named(node: NodeClass, kept: list[str | None]) -> int:
    """How often a class reads its publisher."""
    return sum(
        isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Load) and written(each) in kept
        for each in node.inner
    )


def _repeats(function: ast.AST) -> bool:
    """Whether a function may send several times in one turn."""
    return any(isinstance(each, (ast.For, ast.While)) for each in ast.walk(function))


def _only_timer(node: NodeClass, method: str) -> Timer | None:
    """The one timer that runs a method which nothing else names."""
    uses = [each for each in node.inner if isinstance(each, ast.Attribute) and each.attr == method]
    timers = [each for each in node.all_timers if each.callback == method]
    return timers[0] if len(timers) == 1 and len(uses) == 1 else None
