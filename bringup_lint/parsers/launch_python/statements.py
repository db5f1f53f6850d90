"""Statements of a launch file's own code, run over all branches that may happen."""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any

from bringup_lint.model.launch import Import
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.python import FunctionNode
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python.containers import extend
from bringup_lint.parsers.launch_python.expressions import located_name
from bringup_lint.parsers.launch_python.loops import run_for
from bringup_lint.parsers.launch_python.loops import run_while
from bringup_lint.parsers.launch_python.objects import Function
from bringup_lint.parsers.launch_python.objects import Guards
from bringup_lint.parsers.launch_python.objects import Jump
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.operators import binary
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.state import relative
from bringup_lint.parsers.launch_python.targets import assign
from bringup_lint.parsers.launch_python.truth import branch
from bringup_lint.parsers.launch_python.truth import negated

_ABSENT = object()
_WEAKER = ("continue", "break", "return", "raise")


def run(state: State, body: list[ast.stmt]) -> str | None:
    """Run statements; ``return``, ``break``, ``continue`` or ``raise`` when the block certainly ends so."""
    for statement in body:
        state.tick()
        handler = _HANDLERS.get(type(statement))
        if handler is None:
            continue
        signal = handler(state, statement)
        if signal is not None:
            return signal
    return None


def _expression(state: State, node: ast.Expr) -> None:
    if type(node.value) is not ast.Constant:
        state.evaluate(node.value)


def _assign(state: State, node: ast.Assign) -> None:
    value = state.evaluate(node.value)
    for target in node.targets:
        assign(state, target, value)
    if isinstance(value, Argument) and isinstance(node.value, ast.Call) and isinstance(node.targets[0], ast.Name):
        state.file.bound.append((value, node.targets[0].id))


def _annotated(state: State, node: ast.AnnAssign) -> None:
    if node.value is not None:
        assign(state, node.target, state.evaluate(node.value))


def _augmented(state: State, node: ast.AugAssign) -> None:
    load = _as_load(node.target)
    before = state.evaluate(load)
    value = state.evaluate(node.value)
    if isinstance(before, Sequence) and isinstance(node.op, ast.Add):
        extend(state, before, value, relative(state.guards, before.base))
        return
    assign(state, node.target, binary(state, node.op, before, value, state.positions.span(node)))


def _as_load(target: ast.expr) -> ast.expr:
    if isinstance(target, ast.Name):
        return ast.copy_location(ast.Name(target.id, ast.Load()), target)
    return target


def _if(state: State, node: ast.If) -> str | None:
    outcome = branch(state, state.condition(node.test), state.positions.span(node.test))
    if isinstance(outcome, bool):
        return run(state, node.body if outcome else node.orelse)
    return _fork(state, outcome, node.body, node.orelse)


def _fork(state: State, condition: Condition, body: list[ast.stmt], orelse: list[ast.stmt]) -> str | None:
    """Run both branches, each under its condition, and join the variables."""
    outer = state.guards
    if len(outer) > budget.GUARDS:
        raise budget.Exhausted
    other = negated(condition)
    frame = state.frame
    before = dict(frame.names)
    state.guards = (*outer, condition)
    first = _end(state, run(state, body))
    frame.names = before
    state.guards = (*outer, other)
    second = _end(state, run(state, orelse))
    if first.signal and second.signal:
        return _both_leave(state, first, second)
    if first.signal:
        state.jumps.append(first)
        return None
    if second.signal:
        state.jumps.append(second)
        frame.names, state.guards = first.names, first.guards
        return None
    state.guards = outer
    frame.names = _joined(state, condition, other, first.names, second.names)
    if len(first.guards) > len(outer) + 1 or len(second.guards) > len(outer) + 1:
        left = Unknown("an earlier return", condition.span)
        state.guards = (*outer, Condition(left, True, "python", condition.span))
    return None


def _end(state: State, signal: str | None) -> Jump:
    """Where a branch ends: with a jump, or with the last statement."""
    return Jump(signal or "", state.guards, state.frame.names)


def _both_leave(state: State, first: Jump, second: Jump) -> str:
    """What certainly happens is the weaker of the two; the other one perhaps."""
    weak, strong = sorted((second, first), key=lambda jump: _WEAKER.index(jump.signal))
    state.jumps.append(strong)
    state.frame.names, state.guards = weak.names, weak.guards
    return weak.signal


def _joined(
    state: State, yes: Condition, no: Condition, first: dict[str, Any], second: dict[str, Any]
) -> dict[str, Any]:
    result = dict(second)
    state.tick(len(first) // 8)
    for name, value in first.items():
        other = second.get(name, _ABSENT)
        if other is value:
            continue
        options: list[tuple[Guards, Any]] = [((yes,), value)]
        if other is not _ABSENT:
            options.append(((no,), other))
        result[name] = Options(options, yes.span)
    for name in second.keys() - first.keys():
        result[name] = Options([((no,), second[name])], yes.span)
    return result


def _return(state: State, node: ast.Return) -> str:
    value = None if node.value is None else state.evaluate(node.value)
    state.frame.returns.append((state.guards, value))
    return "return"


def _try(state: State, node: Any) -> str | None:
    signal = run(state, node.body)
    for handler in node.handlers:
        span = state.positions.span(handler)
        if handler.type is None and not any(isinstance(inner, ast.Raise) for inner in ast.walk(handler)):
            state.file.bare_excepts.append(span)
        if handler.name:
            state.frame.names[handler.name] = Unknown("exception", span)
        failed = Condition(Unknown("exception", span), True, "python", span)
        _fork(state, failed, handler.body, [])
    if signal is None:
        signal = run(state, node.orelse)
    return run(state, node.finalbody) or (signal if not node.handlers else None)


def _with(state: State, node: ast.With | ast.AsyncWith) -> str | None:
    for item in node.items:
        value = state.evaluate(item.context_expr)
        if item.optional_vars is not None:
            assign(state, item.optional_vars, value)
    return run(state, node.body)


def _define(state: State, node: FunctionNode) -> None:
    defaults = tuple(state.evaluate(default) for default in node.args.defaults)
    named = zip(node.args.kwonlyargs, node.args.kw_defaults)
    keywords = {arg.arg: state.evaluate(default) for arg, default in named if default is not None}
    state.frame.names[node.name] = Function(node, state.frame, node.name, defaults, keywords)


def _class(state: State, node: ast.ClassDef) -> None:
    state.frame.names[node.name] = Unknown(f"class {node.name}", state.positions.span(node))


def _import(state: State, node: ast.Import) -> None:
    for alias in node.names:
        name = alias.name if alias.asname else alias.name.partition(".")[0]
        state.frame.names[alias.asname or name] = Symbol(name, state.positions.span(node))


def _import_from(state: State, node: ast.ImportFrom) -> None:
    module = node.module or ""
    for alias in node.names:
        name = located_name(state, alias, node)
        if node.level == 0:
            state.file.imports.append(Import(module, name))
        full = f"{'.' * node.level}{module}.{alias.name}"
        state.frame.names[alias.asname or alias.name] = Symbol(full, name.span)


def _outer(state: State, node: ast.Global | ast.Nonlocal) -> None:
    if isinstance(node, ast.Global):
        top = state.frame
        while top.parent is not None:
            top = top.parent
        state.frame.outer.update(dict.fromkeys(node.names, top))
        return
    for name in node.names:
        frame = state.frame.parent
        while frame is not None and name not in frame.names:
            frame = frame.parent
        if frame is not None:
            state.frame.outer[name] = frame


def _delete(state: State, node: ast.Delete) -> None:
    for target in node.targets:
        if isinstance(target, ast.Name):
            state.frame.names[target.id] = Unknown("deleted", state.positions.span(target))
        elif isinstance(target, ast.Subscript):
            _delete_item(state.evaluate(target.value), state.evaluate(target.slice), bool(state.guards))


def _delete_item(owner: Any, key: Any, perhaps: bool) -> None:
    """What may be deleted, or is not known, leaves the container open."""
    if not isinstance(owner, (Mapping, Sequence)):
        return
    if isinstance(owner, Mapping) and isinstance(key, Literal) and not perhaps:
        owner.entries.pop(key.value, None)
    else:
        owner.open = True


def _match(state: State, node: Any) -> None:
    span = state.positions.span(node.subject)
    for case in node.cases:
        chosen = Condition(Unknown("match", span), True, "python", span)
        for inner in ast.walk(case.pattern):
            name = getattr(inner, "name", None)
            if isinstance(name, str):
                state.frame.names[name] = Unknown("match", span)
        _fork(state, chosen, case.body, [])


_HANDLERS: dict[type[ast.stmt], Callable[[State, Any], str | None]] = {
    ast.Expr: _expression,
    ast.Assign: _assign,
    ast.AnnAssign: _annotated,
    ast.AugAssign: _augmented,
    ast.If: _if,
    ast.Return: _return,
    ast.For: run_for,
    ast.AsyncFor: run_for,
    ast.While: run_while,
    ast.Try: _try,
    ast.With: _with,
    ast.AsyncWith: _with,
    ast.FunctionDef: _define,
    ast.AsyncFunctionDef: _define,
    ast.ClassDef: _class,
    ast.Import: _import,
    ast.ImportFrom: _import_from,
    ast.Global: _outer,
    ast.Nonlocal: _outer,
    ast.Delete: _delete,
    ast.Raise: lambda state, node: "raise",
    ast.Break: lambda state, node: "break",
    ast.Continue: lambda state, node: "continue",
    ast.Match: _match,
}
if hasattr(ast, "TryStar"):
    _HANDLERS[ast.TryStar] = _try
