"""Assignment to names, tuples, items and attributes."""

from __future__ import annotations

import ast
from typing import Any

from bringup_lint.model.launch import SetArgument
from bringup_lint.model.launch import SetEnv
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.containers import put
from bringup_lint.parsers.launch_python.objects import Bound
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.state import relative


def assign(state: State, target: ast.expr, value: Any) -> None:
    if isinstance(target, ast.Name):
        frame = state.frame.outer.get(target.id, state.frame)
        frame.names[target.id] = value
    elif isinstance(target, (ast.Tuple, ast.List)):
        _unpack(state, target, value)
    elif isinstance(target, ast.Subscript):
        _set_item(state, target, value)
    elif isinstance(target, ast.Starred):
        assign(state, target.value, value)


def _unpack(state: State, target: ast.Tuple | ast.List, value: Any) -> None:
    items = value.plain() if isinstance(value, Sequence) else None
    starred = any(type(element) is ast.Starred for element in target.elts)
    if items is None or starred or len(items) != len(target.elts):
        why = value.why if isinstance(value, Unknown) else "unpacking"
        items = [Unknown(why, state.positions.span(element)) for element in target.elts]
    for element, item in zip(target.elts, items):
        assign(state, element, item)


def _set_item(state: State, target: ast.Subscript, value: Any) -> None:
    owner = state.evaluate(target.value)
    if type(target.slice) is ast.Slice:
        if isinstance(owner, Sequence):
            owner.open = True
        return
    key = state.evaluate(target.slice)
    if isinstance(owner, Mapping):
        put(state, owner, key, value)
    elif isinstance(owner, Sequence):
        _replace(state, owner, key, value)
    elif isinstance(owner, Bound) and owner.name == "launch_configurations":
        span = state.positions.span(target)
        setting = SetArgument(span=span, name=freeze.value(state, key), value=freeze.value(state, value))
        state.effects.append(freeze.under(setting, state.guards))
    elif isinstance(owner, Symbol) and owner.name == "os.environ":
        span = state.positions.span(target)
        export = SetEnv(span=span, name=freeze.value(state, key), value=freeze.value(state, value))
        state.effects.append(freeze.under(export, state.guards))


def _replace(state: State, owner: Sequence, key: Any, value: Any) -> None:
    index = key.value if isinstance(key, Literal) else None
    if owner.plain() is None or type(index) is not int or not -len(owner.items) <= index < len(owner.items):
        owner.open = True
        return
    guards = relative(state.guards, owner.base)
    if guards:
        value = Options([((), owner.items[index][1]), (guards, value)], owner.span)
    owner.items[index] = ((), value)
