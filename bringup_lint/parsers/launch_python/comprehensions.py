"""Comprehensions, unrolled over what is known."""

from __future__ import annotations

import ast
from typing import Any

from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python.containers import append
from bringup_lint.parsers.launch_python.containers import iterate
from bringup_lint.parsers.launch_python.containers import put
from bringup_lint.parsers.launch_python.objects import Frame
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.targets import assign
from bringup_lint.parsers.launch_python.truth import branch


def comprehension(state: State, node: ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp) -> Any:
    span = state.positions.span(node)
    result = Mapping(span, base=state.guards) if type(node) is ast.DictComp else Sequence([], span, state.guards)
    outer, guards = state.frame, state.guards
    state.frame = Frame({}, outer)
    try:
        _clause(state, node, 0, result)
    finally:
        state.frame, state.guards = outer, guards
    return result


def _clause(state: State, node: Any, index: int, result: Mapping | Sequence) -> None:
    if index == len(node.generators):
        if isinstance(result, Mapping):
            put(state, result, state.evaluate(node.key), state.evaluate(node.value))
        else:
            append(state, result, state.evaluate(node.elt))
        return
    clause = node.generators[index]
    span = state.positions.span(clause.iter)
    items = iterate(state, state.evaluate(clause.iter))
    outer = state.guards
    if items is None:
        loop = Condition(Unknown("loop", span), True, "loop", span)
        items = [((loop,), Unknown("loop item", span))]
        result.open = result.open or isinstance(result, Mapping)
    for guards, item in items:
        state.tick()
        state.guards = outer + guards
        assign(state, clause.target, item)
        if _passes(state, clause.ifs):
            _clause(state, node, index + 1, result)
    state.guards = outer


def _passes(state: State, tests: list[ast.expr]) -> bool:
    for test in tests:
        outcome = branch(state, state.condition(test), state.positions.span(test))
        if outcome is False:
            return False
        if outcome is not True:
            state.guards = (*state.guards, outcome)
    return True
