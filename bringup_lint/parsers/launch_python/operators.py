"""Operators of Python on evaluated objects."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable
from typing import Any

from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PackagePrefix
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.containers import extend
from bringup_lint.parsers.launch_python.containers import merge
from bringup_lint.parsers.launch_python.containers import presence
from bringup_lint.parsers.launch_python.objects import Bound
from bringup_lint.parsers.launch_python.objects import Guards
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.truth import truth
from bringup_lint.parsers.launch_python.unperformed import is_object
from bringup_lint.parsers.launch_python.unperformed import note_object
from bringup_lint.source import Located
from bringup_lint.source import Span

_TEXTS = (Argument, Env, Concat, PathJoin, PackageShare, PackagePrefix, FileDir, Operation, Choice)
_DECIDED_LATER = (Argument, Env, Choice, Concat, Operation)
_NUMBERS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv}
_NUMBERS |= {ast.FloorDiv: operator.floordiv, ast.Mod: operator.mod}
_ORDER: dict[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}


def performed(state: State, thing: Any, span: Span) -> Value:
    """The value as text inside an f-string or ``str()``: a substitution object would print as an object."""
    value = freeze.value(state, thing)
    if is_object(value):
        note_object(state, "text", value, span)
        return Unknown("a substitution object as text", span)
    if isinstance(value, Literal) and not isinstance(value.value, str):
        return Literal(Located(str(value.value), value.span), value.span)
    return value


def binary(state: State, op: ast.operator, left: Any, right: Any, span: Span) -> Any:
    kind = type(op)
    is_path = kind is ast.Div and isinstance(left, Literal) and isinstance(left.value, str)
    if isinstance(left, Literal) and isinstance(right, Literal) and not is_path:
        return _literals(kind, left, right, span)
    if kind is ast.Add:
        if isinstance(left, Sequence):
            result = Sequence(list(left.items), span, state.guards, left.open)
            extend(state, result, right, ())
            return result
        if isinstance(right, Sequence) or isinstance(left, Mapping):
            return Unknown("addition", span)
        if isinstance(left, Options) or isinstance(right, Options):
            return _added(state, left, right, span)
        if _is_text(left) and _is_text(right):
            for thing in (left, right):
                note_object(state, "added", thing, span)
            return budget.concat([freeze.value(state, left), freeze.value(state, right)], span)
    if kind is ast.Div:
        first = freeze.value(state, left)
        if isinstance(first, (*_TEXTS, Literal)) and not isinstance(right, (Sequence, Mapping)):
            inner = first.parts if isinstance(first, PathJoin) else (first,)
            return budget.bounded(PathJoin((*inner, freeze.text(state, right)), span))
    if kind is ast.BitOr and isinstance(left, Mapping):
        merged = Mapping(span, dict(left.entries), list(left.others), left.open, state.guards)
        merge(state, merged, right)
        return merged
    if kind is ast.Mod and isinstance(left, Literal) and isinstance(left.value, str):
        return _percent(state, left, right, span)
    return Unknown("operator", span)


def _is_text(thing: Any) -> bool:
    return isinstance(thing, _TEXTS) or (isinstance(thing, Literal) and isinstance(thing.value, str))


def _added(state: State, left: Any, right: Any, span: Span) -> Any:
    lefts = left.options if isinstance(left, Options) else [((), left)]
    rights = right.options if isinstance(right, Options) else [((), right)]
    state.tick(len(lefts) * len(rights))
    if len(lefts) * len(rights) > budget.GUARDS:
        return Unknown("too many cases", span)
    add = ast.Add()
    return Options([(a + b, binary(state, add, x, y, span)) for a, x in lefts for b, y in rights], span)


def _literals(kind: type, left: Literal, right: Literal, span: Span) -> Any:
    a, b = left.value, right.value
    if kind is not ast.Mod and isinstance(a, str) and isinstance(b, str):
        if kind is ast.Add and len(a) + len(b) <= budget.LENGTH:
            return Literal(Located(str(a) + str(b), span), span)
        return Unknown("operator", span)
    if kind is ast.Mod and isinstance(a, str):
        return _formatted(str(a), b, span)
    numbers = (int, float)
    if kind in _NUMBERS and isinstance(a, numbers) and isinstance(b, numbers):
        try:
            result = _NUMBERS[kind](a, b)
        except ArithmeticError:
            return Unknown("arithmetic", span)
        if isinstance(result, int) and abs(result) > 1 << 64:
            return Unknown("arithmetic", span)
        return Literal(result, span)
    return Unknown("operator", span)


def _formatted(pattern: str, value: Any, span: Span) -> Any:
    if pattern.count("%") != 1 or "*" in pattern or any(char.isdecimal() for char in pattern.partition("%")[2][:4]):
        return Unknown("number format", span)
    try:
        return Literal(Located(pattern % (value,), span), span)
    except (TypeError, ValueError):
        return Unknown("format", span)


def _percent(state: State, pattern: Literal, right: Any, span: Span) -> Any:
    """``'...%s...' % values``."""
    items = right.plain() if isinstance(right, Sequence) else [right]
    texts = str(pattern.value).split("%s")
    if items is None or len(texts) != len(items) + 1 or any("%" in part for part in texts):
        return Unknown("format", span)
    parts: list[Value] = []
    for before, item in zip(texts, [*items, None]):
        if before:
            parts.append(Literal(Located(before, span), span))
        if item is not None:
            parts.append(performed(state, item, span))
    return joined(parts, span)


def joined(parts: list[Value], span: Span) -> Value:
    """Text of parts; one literal when all are."""
    literals = [part for part in parts if isinstance(part, Literal)]
    if len(literals) == len(parts):
        text = "".join(str(part.value) for part in literals)
        return Literal(Located(text, span), span) if len(text) <= budget.LENGTH else Unknown("too large", span)
    return budget.concat(parts, span)


def unary(state: State, op: ast.unaryop, operand: Any, span: Span) -> Any:
    if isinstance(op, ast.Not):
        note_object(state, "condition", operand, span)
        outcome = truth(state, operand, span)
        if isinstance(outcome, bool):
            return Literal(not outcome, span)
        return budget.bounded(Operation("not", (outcome,), span))
    number = operand.value if isinstance(operand, Literal) else None
    if isinstance(number, (int, float)) and not isinstance(number, bool) and not isinstance(op, ast.Invert):
        return Literal(-number if isinstance(op, ast.USub) else number, span)
    return Unknown("operator", span)


def compare(state: State, op: ast.cmpop, left: Any, right: Any, span: Span) -> Any:
    """A literal bool, an ``Operation`` on values, or Unknown."""
    kind = type(op)
    if kind in (ast.Is, ast.IsNot):
        return _identity(left, right, kind is ast.IsNot, span)
    if kind in (ast.In, ast.NotIn):
        return _membership(state, left, right, kind is ast.NotIn, span)
    if isinstance(left, Literal) and isinstance(right, Literal):
        if kind in (ast.Eq, ast.NotEq):
            return Literal((left.value == right.value) is (kind is ast.Eq), span)
        try:
            return Literal(bool(_ORDER[kind](left.value, right.value)), span)
        except TypeError:
            return Unknown("comparison", span)
    if kind in (ast.Eq, ast.NotEq) and _is_text(left) and _is_text(right):
        if is_object(left) != is_object(right):
            thing, text = (left, right) if is_object(left) else (right, left)
            empty = isinstance(text, Literal) and text.value == ""
            note_object(state, "compared with nothing" if empty else "compared", thing, span)
            return Literal(kind is ast.NotEq, span)
        operands = (freeze.value(state, left), freeze.value(state, right))
        return budget.bounded(Operation("==" if kind is ast.Eq else "!=", operands, span))
    return Unknown("comparison", span)


def _identity(left: Any, right: Any, negative: bool, span: Span) -> Any:
    if freeze.is_none(right):
        if isinstance(left, (Unknown, Options, Choice)):
            return Unknown("comparison with None", span)
        if isinstance(left, Env):
            return Unknown("environment", span)
        return Literal(freeze.is_none(left) is not negative, span)
    if isinstance(left, Literal) and isinstance(right, Literal) and isinstance(right.value, bool):
        return Literal((left.value is right.value) is not negative, span)
    return Unknown("identity", span)


def _membership(state: State, left: Any, right: Any, negative: bool, span: Span) -> Any:
    if isinstance(left, Literal):
        if isinstance(right, Literal) and isinstance(right.value, str) and isinstance(left.value, str):
            return Literal((left.value in right.value) is not negative, span)
        if isinstance(right, Mapping) and not right.open and not right.others:
            return _is_key(left.value, right, negative, span)
    items = right.plain() if isinstance(right, Sequence) else None
    if items is None:
        return Unknown("membership", span)
    state.tick(len(items))
    results = [compare(state, ast.Eq(), left, item, span) for item in items]
    if any(isinstance(result, Literal) and result.value for result in results):
        return Literal(not negative, span)
    open_results = [result for result in results if not isinstance(result, Literal)]
    if not open_results:
        return Literal(negative, span)
    found = open_results[0] if len(open_results) == 1 else budget.bounded(Operation("or", tuple(open_results), span))
    return Operation("not", (found,), span) if negative else found


def _is_key(key: Any, mapping: Mapping, negative: bool, span: Span) -> Any:
    if key in mapping.entries and presence(mapping.entries[key][1]) != ():
        return Unknown("membership", span)
    return Literal((key in mapping.entries) is not negative, span)


def subscript(state: State, owner: Any, key: Any, span: Span) -> Any:
    """``owner[key]``; a list of three for a slice."""
    if isinstance(owner, Bound) and owner.name == "launch_configurations":
        return configuration(state, key, None, span)
    if isinstance(owner, Symbol) and owner.name == "os.environ":
        if isinstance(key, Literal) and isinstance(key.value, Located):
            return Env(key.value, None, span)
        return Unknown("environment", span)
    if isinstance(owner, Mapping) and isinstance(key, Literal):
        if key.value in owner.entries:
            return owner.entries[key.value][1]
        return Unknown("key", span)
    if isinstance(owner, Mapping):
        note_object(state, "looked-up", key, span)
    if isinstance(owner, Mapping) and not owner.open and not owner.others and isinstance(key, _DECIDED_LATER):
        return _selected(state, owner, key, span)
    if isinstance(owner, (Sequence, Literal)):
        return _item(state, owner, key, span)
    if isinstance(owner, Options):
        return Options([(guards, subscript(state, option, key, span)) for guards, option in owner.options], span)
    return Unknown("subscript", span)


def _selected(state: State, owner: Mapping, key: Value, span: Span) -> Any:
    """A dictionary read by a value that the run decides: one of its values, each by its condition."""
    if len(owner.entries) > budget.GUARDS or not owner.entries:
        return Unknown("subscript", span)
    options: list[tuple[Guards, Any]] = []
    for name, item in owner.entries.values():
        if not isinstance(name, Literal):
            return Unknown("subscript", span)
        options.append(((Condition(Operation("==", (key, name), span), True, "python", span),), item))
    return Options(options, span)


def configuration(state: State, key: Any, default: Any, span: Span) -> Any:
    """A launch configuration read from the context by deferred code."""
    if isinstance(key, Literal) and isinstance(key.value, Located):
        fallback = None if default is None else freeze.value(state, default)
        result = Argument(key.value, fallback, span, performed=True)
        state.file.reads.append(result)
        return result
    state.file.reads_all = True
    return Unknown("launch configuration", span)


def _item(state: State, owner: Sequence | Literal, key: Any, span: Span) -> Any:
    if isinstance(owner, Literal):
        whole: Any = owner.value if isinstance(owner.value, str) else None
    else:
        whole = owner.plain()
    if whole is None:
        return Unknown("subscript", span)
    if isinstance(key, list):
        bounds = [part.value if isinstance(part, Literal) else part for part in key]
        if not all(part is None or type(part) is int for part in bounds) or bounds[2] == 0:
            return Unknown("slice", span)
        found = whole[slice(*bounds)]
        if isinstance(owner, Literal):
            return Literal(Located(str(found), span), span)
        state.tick(len(found))
        return Sequence([((), item) for item in found], span, state.guards)
    if not isinstance(key, Literal) or type(key.value) not in (int, bool):
        return Unknown("subscript", span)
    try:
        found = whole[key.value]
    except IndexError:
        return Unknown("index", span)
    return Literal(Located(str(found), span), span) if isinstance(owner, Literal) else found
