"""Loops of a launch file's own code, with the rounds that a condition ends early."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from typing import Any

from bringup_lint.model.launch_values import VALUE_TYPES
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python.containers import iterate
from bringup_lint.parsers.launch_python.objects import Guards
from bringup_lint.parsers.launch_python.objects import Jump
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.state import relative
from bringup_lint.parsers.launch_python.targets import assign
from bringup_lint.parsers.launch_python.truth import unless
from bringup_lint.source import Span

_KEPT = 8
"""Conditions of earlier rounds that are told apart."""
_ENDS_FUNCTION = ("return", "raise")


def run_for(state: State, node: ast.For | ast.AsyncFor) -> str | None:
    span = state.positions.span(node.iter)
    items = iterate(state, state.evaluate(node.iter))
    if items is None:
        items = [((_unknown(span),), Unknown("loop item", span))]
    outer, jumps = state.guards, state.jumps
    here = outer
    left: list[Jump] = []
    signal = None
    for guards, item in items:
        state.tick(2)
        signal, ended = _round(state, node, here, guards, item)
        left += ended
        here = _without(outer, here, ended, span)
        if signal in ("break", *_ENDS_FUNCTION):
            break
    state.jumps = [*jumps, *(jump for jump in left if jump.signal in _ENDS_FUNCTION)]
    breaks = [jump for jump in left if jump.signal == "break"]
    if signal == "break":
        signal = None
    elif signal not in _ENDS_FUNCTION:
        state.guards = here
        signal = state.run(node.orelse)
    return _after(state, outer, signal, breaks, span)


def _round(
    state: State, node: ast.For | ast.AsyncFor, here: Guards, guards: Guards, item: Any
) -> tuple[str | None, list[Jump]]:
    """Run the body for one item: how it certainly ends, and the branches that leave the loop."""
    before = dict(state.frame.names) if guards else {}
    state.guards, state.jumps = here + guards, []
    assign(state, node.target, item)
    signal = state.run(node.body)
    names = state.frame.names
    for jump in state.jumps:
        if jump.signal == "continue":
            names = _perhaps(state, names, relative(jump.guards, here), jump.names)
    if guards:
        if signal is not None:
            state.jumps.append(Jump(signal, here + guards, names))
            signal = None
        names = _perhaps(state, before, guards, names)
    state.frame.names = names
    return signal, [jump for jump in state.jumps if jump.signal != "continue"]


def _after(state: State, outer: Guards, signal: str | None, breaks: list[Jump], span: Span) -> str | None:
    """Go on after the loop: with what the breaks leave, and under the condition that nothing returned.

    With a signal, which ends the last round or the ``else``, only breaks lead there.
    """
    names = state.frame.names
    if signal is not None and breaks:
        state.jumps.append(Jump(signal, state.guards, names))
    for jump in breaks:
        names = _perhaps(state, names, relative(jump.guards, outer), jump.names)
    state.frame.names = names
    returned = [jump for jump in state.jumps if jump.signal in _ENDS_FUNCTION]
    if signal is not None and not breaks:
        state.guards = outer
        return signal
    state.guards = _without(outer, outer, returned, span)
    if signal is not None:
        only = relative(breaks[0].guards, outer) if len(breaks) == 1 else (_unknown(span),)
        state.guards += only
    return None


def _without(outer: Guards, here: Guards, jumps: Iterable[Jump], span: Span) -> Guards:
    """The conditions under which none of some branches has left."""
    for jump in jumps:
        known = {id(condition) for condition in here}
        rest = tuple(condition for condition in jump.guards if id(condition) not in known)
        if rest:
            here += (unless(rest),)
    return here if len(here) - len(outer) <= _KEPT else (*outer, _unknown(span))


def _perhaps(state: State, names: dict[str, Any], guards: Guards, others: dict[str, Any]) -> dict[str, Any]:
    """The variables, with others where some conditions hold."""
    result = dict(names)
    state.tick(len(others) // 8)
    for name, value in others.items():
        if name not in names:
            result[name] = Options([(guards, value)], state.file.source.whole)
        elif names[name] is not value:
            result[name] = Options([((), names[name]), (guards, value)], state.file.source.whole)
    return result


def _unknown(span: Span) -> Condition:
    return Condition(Unknown("loop", span), True, "loop", span)


def run_while(state: State, node: ast.While) -> str | None:
    outer, jumps = state.guards, state.jumps
    state.guards, state.jumps = (*outer, _unknown(state.positions.span(node.test))), []
    _forget_assigned(state, node)
    state.run(node.body)
    state.guards, state.jumps = outer, jumps
    _forget_assigned(state, node)
    return None


def _forget_assigned(state: State, node: ast.While) -> None:
    """How often the loop runs is not known, nor what the plain values are that it assigns."""
    for target in ast.walk(node):
        if isinstance(target, ast.Name) and isinstance(target.ctx, ast.Store):
            if isinstance(state.frame.names.get(target.id), VALUE_TYPES):
                state.frame.names[target.id] = Unknown("loop", state.positions.span(target))
