"""Expressions of a launch file's own code."""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any

from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.attributes import attribute
from bringup_lint.parsers.launch_python.comprehensions import comprehension
from bringup_lint.parsers.launch_python.containers import append
from bringup_lint.parsers.launch_python.containers import extend
from bringup_lint.parsers.launch_python.containers import merge
from bringup_lint.parsers.launch_python.containers import put
from bringup_lint.parsers.launch_python.misfits import note_misfit
from bringup_lint.parsers.launch_python.objects import Frame
from bringup_lint.parsers.launch_python.objects import Function
from bringup_lint.parsers.launch_python.objects import Guards
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.operators import binary
from bringup_lint.parsers.launch_python.operators import compare
from bringup_lint.parsers.launch_python.operators import joined
from bringup_lint.parsers.launch_python.operators import performed
from bringup_lint.parsers.launch_python.operators import subscript
from bringup_lint.parsers.launch_python.operators import unary
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.truth import branch
from bringup_lint.parsers.launch_python.truth import negated
from bringup_lint.parsers.launch_python.unbound import note_unbound
from bringup_lint.parsers.python_syntax import located
from bringup_lint.source import Located
from bringup_lint.source import Span

BUILTINS = frozenset(
    "str int float bool len range enumerate zip list tuple dict set sorted reversed print open map filter any all "
    "min max"
    " isinstance getattr hasattr repr type abs round sum next iter super object vars id eval exec input globals locals"
    " frozenset format callable".split()
)


def evaluate(state: State, node: ast.expr) -> Any:
    state.steps -= 1
    if state.steps < 0:
        raise budget.Exhausted
    handler = _HANDLERS.get(type(node))
    if handler is None:
        return state.unknown("expression", node)
    return handler(state, node)


def _constant(state: State, node: ast.Constant) -> Any:
    value = node.value
    span = state.positions.span(node)
    if isinstance(value, str):
        return Literal(located(value, span), span)
    if value is None or isinstance(value, (bool, int, float)):
        return Literal(value, span)
    return Unknown("constant", span)


def located_name(state: State, alias: ast.alias, statement: ast.ImportFrom) -> Located:
    """The imported name with its place; the statement's when the place is not told."""
    lineno = getattr(alias, "lineno", None)
    if lineno is None:
        return Located(alias.name, state.positions.span(statement))
    start = state.positions.offset(lineno, alias.col_offset)
    return Located(alias.name, Span(state.file.source, start, start + len(alias.name)))


def _name(state: State, node: ast.Name) -> Any:
    frame: Frame | None = state.frame
    name = node.id
    while frame is not None:
        if name in frame.names:
            return frame.names[name]
        outer = frame.outer.get(name)
        frame = frame.parent if outer is None or outer is frame else outer
    span = state.positions.span(node)
    if name in BUILTINS:
        return Symbol(f"builtins.{name}", span)
    if name == "__file__":
        return Symbol("__file__", span)
    if name == "__name__":
        return Literal("launch_file", span)
    note_unbound(state, node)
    return Unknown(f"name {name}", span)


def _attribute(state: State, node: ast.Attribute) -> Any:
    return attribute(state, evaluate(state, node.value), node.attr, state.positions.span(node))


def _call(state: State, node: ast.Call) -> Any:
    function = evaluate(state, node.func)
    positional: list[Any] = []
    keywords: dict[str, Any] = {}
    more = False
    for argument in node.args:
        if type(argument) is ast.Starred:
            inner = evaluate(state, argument.value)
            plain = inner.plain() if isinstance(inner, Sequence) else None
            more = more or plain is None
            positional += plain or ()
        else:
            positional.append(evaluate(state, argument))
    for keyword in node.keywords:
        value = evaluate(state, keyword.value)
        if keyword.arg is not None:
            keywords[keyword.arg] = value
        elif isinstance(value, Mapping):
            more = more or value.open or bool(value.others)
            keywords.update((str(key), item) for key, (_, item) in value.entries.items())
        else:
            more = True
    arguments = Arguments(positional, keywords, more, state.positions.span(node))
    note_misfit(state, function, node, arguments)
    return state.call(function, positional, keywords, more, arguments.span)


def _sequence(state: State, node: ast.List | ast.Tuple | ast.Set) -> Sequence:
    result = Sequence([], state.positions.span(node), state.guards)
    for element in node.elts:
        if type(element) is ast.Starred:
            extend(state, result, evaluate(state, element.value), ())
        else:
            result.items.append(((), evaluate(state, element)))
    return result


def _dict(state: State, node: ast.Dict) -> Mapping:
    result = Mapping(state.positions.span(node), base=state.guards)
    for key, value in zip(node.keys, node.values):
        if key is None:
            merge(state, result, evaluate(state, value))
        else:
            put(state, result, evaluate(state, key), evaluate(state, value))
    return result


def _joined(state: State, node: ast.JoinedStr) -> Any:
    span = state.positions.span(node)
    parts = []
    for part in node.values:
        if type(part) is ast.FormattedValue:
            inner = evaluate(state, part.value)
            if part.format_spec is not None:
                inner = Unknown("number format", span)
            parts.append(performed(state, inner, span))
        elif type(part) is ast.Constant and isinstance(part.value, str):
            at = span.source.text.find(part.value, span.start, span.end) if part.value else -1
            where = span if at < 0 else Span(span.source, at, at + len(part.value))
            parts.append(Literal(Located(part.value, where), where))
    if not parts:
        return Literal(Located("", span), span)
    return joined(parts, span)


def _ternary(state: State, node: ast.IfExp) -> Any:
    span = state.positions.span(node)
    outcome = branch(state, condition(state, node.test), state.positions.span(node.test))
    if outcome is True:
        return evaluate(state, node.body)
    if outcome is False:
        return evaluate(state, node.orelse)
    body, otherwise = evaluate(state, node.body), evaluate(state, node.orelse)
    return Options([((outcome,), body), ((negated(outcome),), otherwise)], span)


def condition(state: State, node: ast.expr) -> Any:
    """An expression of which only the truth counts."""
    if isinstance(node, ast.BoolOp):
        operands = _operands(state, node, condition)
        return operands[0] if len(operands) == 1 else _truth(state, node, operands)
    return evaluate(state, node)


def _bool(state: State, node: ast.BoolOp) -> Any:
    """The value of ``and`` and ``or``: the first operand that decides, else the last one."""
    operands = _operands(state, node, evaluate)
    if len(operands) == 1:
        return operands[0]
    if all(isinstance(each, Operation) for each in operands):
        return _truth(state, node, operands)
    span = state.positions.span(node)
    options: list[tuple[Guards, Any]] = [((), operands[-1])]
    for value in reversed(operands[:-1]):
        outcome = branch(state, value, span)
        if isinstance(outcome, Condition):
            options.append(((outcome if isinstance(node.op, ast.Or) else negated(outcome),), value))
    return Options(options, span)


def _operands(state: State, node: ast.BoolOp, read: Callable[[State, ast.expr], Any]) -> list[Any]:
    """The operands from the left, up to one that certainly decides, without those that certainly do not."""
    wanted = isinstance(node.op, ast.Or)
    left: list[Any] = []
    for operand in node.values:
        value = read(state, operand)
        outcome = branch(state, value, state.positions.span(operand))
        last = operand is node.values[-1]
        if outcome is wanted or last or not isinstance(outcome, bool):
            left.append(value)
        if outcome is wanted:
            break
    return left


def _truth(state: State, node: ast.BoolOp, operands: list[Any]) -> Any:
    span = state.positions.span(node)
    outcomes = [branch(state, value, span) for value in operands]
    predicates = (Literal(each, span) if isinstance(each, bool) else each.predicate for each in outcomes)
    return budget.bounded(Operation("or" if isinstance(node.op, ast.Or) else "and", tuple(predicates), span))


def _compare(state: State, node: ast.Compare) -> Any:
    span = state.positions.span(node)
    left = evaluate(state, node.left)
    outcomes = []
    for operator, right_node in zip(node.ops, node.comparators):
        right = evaluate(state, right_node)
        outcomes.append(compare(state, operator, left, right, span))
        left = right
    if len(outcomes) == 1:
        return outcomes[0]
    if all(isinstance(outcome, Literal) for outcome in outcomes):
        return Literal(all(outcome.value for outcome in outcomes), span)
    return budget.bounded(Operation("and", tuple(freeze.value(state, outcome) for outcome in outcomes), span))


def _binary(state: State, node: ast.BinOp) -> Any:
    left = evaluate(state, node.left)
    right = evaluate(state, node.right)
    return binary(state, node.op, left, right, state.positions.span(node))


def _unary(state: State, node: ast.UnaryOp) -> Any:
    read = condition if isinstance(node.op, ast.Not) else evaluate
    return unary(state, node.op, read(state, node.operand), state.positions.span(node))


def _subscript(state: State, node: ast.Subscript) -> Any:
    owner = evaluate(state, node.value)
    if type(node.slice) is ast.Slice:
        parts = (node.slice.lower, node.slice.upper, node.slice.step)
        bounds = [None if part is None else evaluate(state, part) for part in parts]
        return subscript(state, owner, bounds, state.positions.span(node))
    return subscript(state, owner, evaluate(state, node.slice), state.positions.span(node))


def _lambda(state: State, node: ast.Lambda) -> Function:
    defaults = tuple(evaluate(state, default) for default in node.args.defaults)
    return Function(node, state.frame, "lambda", defaults)


def _walrus(state: State, node: ast.NamedExpr) -> Any:
    value = evaluate(state, node.value)
    state.frame.names[node.target.id] = value
    return value


def _await(state: State, node: ast.Await) -> Any:
    return evaluate(state, node.value)


def _yield(state: State, node: ast.Yield | ast.YieldFrom) -> Any:
    """A generator's values are gathered; nobody sends any back."""
    span = state.positions.span(node)
    frame = state.frame
    if frame.yielded is None:
        frame.yielded = Sequence([], span, ())
    if isinstance(node, ast.YieldFrom):
        extend(state, frame.yielded, evaluate(state, node.value), state.guards)
    elif node.value is not None:
        append(state, frame.yielded, evaluate(state, node.value))
    return Unknown("sent value", span)


_HANDLERS: dict[type[ast.expr], Callable[[State, Any], Any]] = {
    ast.Constant: _constant,
    ast.Name: _name,
    ast.Attribute: _attribute,
    ast.Call: _call,
    ast.List: _sequence,
    ast.Tuple: _sequence,
    ast.Set: _sequence,
    ast.Dict: _dict,
    ast.JoinedStr: _joined,
    ast.IfExp: _ternary,
    ast.BoolOp: _bool,
    ast.Compare: _compare,
    ast.BinOp: _binary,
    ast.UnaryOp: _unary,
    ast.Subscript: _subscript,
    ast.Lambda: _lambda,
    ast.NamedExpr: _walrus,
    ast.Await: _await,
    ast.Yield: _yield,
    ast.YieldFrom: _yield,
    ast.ListComp: comprehension,
    ast.SetComp: comprehension,
    ast.GeneratorExp: comprehension,
    ast.DictComp: comprehension,
}
