"""Values of a launch file in a launch context: arguments filled in, texts joined, predicates decided."""

from __future__ import annotations

import math
import posixpath
from collections.abc import Callable
from collections.abc import Iterable
from typing import Any

from bringup_lint.graph.launch.python_expression import NotEvaluated
from bringup_lint.graph.launch.python_expression import evaluate
from bringup_lint.graph.launch.scope import EnvChanges
from bringup_lint.graph.launch.scope import Scope
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PackagePrefix
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.source import Located
from bringup_lint.source import Span

DEPTH = 40
LENGTH = 100_000
PARTS = 1000
TRUE = ("true", "1")
FALSE = ("false", "0")


class Resolver:
    """``symbolic`` keeps what the user may pass on the command line; otherwise its default stands for it."""

    def __init__(self, scope: Scope, symbolic: bool = False) -> None:
        self.scope = scope
        self.symbolic = symbolic
        self.depth = 0

    def value(self, value: Value) -> Value:
        if isinstance(value, (Literal, Unknown)):
            return value
        if self.depth > DEPTH:
            return Unknown("nested too deeply", value.span)
        self.depth += 1
        try:
            return _RESOLVE.get(type(value), _same)(self, value)
        finally:
            self.depth -= 1

    def optional(self, value: Value | None) -> Value | None:
        return None if value is None else self.value(value)

    def values(self, values: Iterable[Value]) -> tuple[Value, ...]:
        return tuple(self.value(value) for value in values)

    def pairs(self, pairs: Iterable[tuple[Value, Value]]) -> tuple[tuple[Value, Value], ...]:
        return tuple((self.value(first), self.value(second)) for first, second in pairs)

    def holds(self, condition: Condition) -> bool | None:
        """Whether a condition is met; None when that is not known."""
        if condition.kind == "loop":
            return None
        outcome = truth(self.value(condition.predicate), launch=condition.kind != "python")
        return None if outcome is None else outcome is condition.wanted

    def all_hold(self, conditions: Iterable[Condition]) -> bool | None:
        outcomes = [self.holds(condition) for condition in conditions]
        return False if False in outcomes else (None if None in outcomes else True)


def truth(value: Value, launch: bool = True) -> bool | None:
    """A predicate's truth; ``launch``: text counts only as true, false, 1 or 0."""
    if not isinstance(value, Literal):
        return None
    if isinstance(value.value, str):
        word = value.value.strip().lower()
        return True if word in TRUE else (False if word in FALSE else None)
    if launch and not isinstance(value.value, bool):
        return bool(value.value) if value.value in (0, 1) else None
    return bool(value.value)


def _same(self: Resolver, value: Value) -> Value:
    return value


def _argument(self: Resolver, value: Argument) -> Value:
    binding = self.scope.arguments.get(str(value.name))
    if binding is not None:
        return binding.symbol if self.symbolic else binding.value
    if value.default is not None:
        default = self.value(value.default)
        return Argument(value.name, default, value.span, value.performed) if self.symbolic else default
    return value


def _env(self: Resolver, value: Env) -> Value:
    changes = self.scope.env.get(str(value.name)) if value.scoped else None
    if not changes:
        return Env(value.name, self.optional(value.default), value.span, value.scoped)
    last = changes[-1]
    if last.is_plain:
        default = Unknown("unset environment variable", value.span) if value.default is None else value.default
        return self.value(default) if last.value is None else last.value
    return _extended(changes, value.span)


def _extended(changes: EnvChanges, span: Span) -> Value:
    """What a variable holds after something was put to the end or front of it."""
    start = max((at for at, change in enumerate(changes) if change.is_plain), default=None)
    counted = () if start is None else changes[start:]
    certain = [each.value for each in counted if each.value is not None and each.certain]
    texts = texts_of(certain)
    if not texts or len(texts) < len(counted):
        return Unknown("extended environment", span)
    result = texts[0]
    for change, text in zip(counted[1:], texts[1:]):
        separator = ":" if change.separator is None else text_of(change.separator)
        if separator is None or len(result) > LENGTH:
            return Unknown("extended environment", span)
        result = separator.join((result, text) if change.mode == "append" else (text, result))
    return Literal(Located(result, span), span)


def text_of(value: Value | None) -> str | None:
    """A literal as the text that launch makes of it."""
    return str(value.value) if isinstance(value, Literal) and value.value is not None else None


def texts_of(values: Iterable[Value]) -> list[str] | None:
    """None when one of them is not literal."""
    found: list[str] = []
    for value in values:
        text = text_of(value)
        if text is None:
            return None
        found.append(text)
    return found


def _concat(self: Resolver, value: Concat) -> Value:
    if _stays(value.parts):
        return value
    parts: list[Value] = []
    for part in self.values(value.parts):
        parts.extend(part.parts if isinstance(part, Concat) else (part,))
    return joined(parts, value.span)


def _stays(parts: tuple[Value, ...]) -> bool:
    """Whether the parts of a text mean the same in every scope, and are not all known."""
    if len(parts) > PARTS or any(type(part) in _RESOLVE for part in parts):
        return False
    return texts_of(parts) is None


def joined(parts: list[Value], span: Span) -> Value:
    texts = texts_of(parts)
    if texts is not None:
        filled = [part for part, text in zip(parts, texts) if text]
        if len(filled) == 1:
            return filled[0]
        text = "".join(texts)
        return Literal(Located(text, span), span) if len(text) <= LENGTH else Unknown("too large", span)
    return Concat(tuple(parts), span) if len(parts) <= PARTS else Unknown("too large", span)


def _path(self: Resolver, value: PathJoin) -> Value:
    parts: list[Value] = []
    for part in self.values(value.parts):
        text = text_of(part)
        if text is not None and text.startswith("/"):
            parts.clear()
        parts.extend(part.parts if isinstance(part, PathJoin) else (part,))
    if len(parts) == 1:
        return parts[0]
    texts = texts_of(parts)
    if texts is None:
        return PathJoin(tuple(parts), value.span)
    return Literal(Located(posixpath.join(*texts), value.span), value.span)


def _operation(self: Resolver, value: Operation) -> Value:
    operands = self.values(value.operands)
    outcome = _OPERATIONS[value.name](operands) if value.name in _OPERATIONS else None
    if outcome is None:
        return Operation(value.name, operands, value.span)
    if isinstance(outcome, (bool, str)):
        return Literal(outcome if isinstance(outcome, bool) else Located(outcome, value.span), value.span)
    return outcome


def _equal(operands: tuple[Value, ...]) -> bool | None:
    left, right = operands
    if isinstance(left, Literal) and isinstance(right, Literal):
        return left.value == right.value
    return None


def _equals(operands: tuple[Value, ...]) -> bool | None:
    """``EqualsSubstitution``: truth values and numbers compare by what they mean."""
    left, right = map(text_of, operands)
    if left is None or right is None:
        return None
    words = (*TRUE, *FALSE)
    if left.lower() in words and right.lower() in words:
        return (left.lower() in TRUE) == (right.lower() in TRUE)
    try:
        return math.isclose(float(left), float(right))
    except ValueError:
        return left == right


def _not_of(outcome: bool | None) -> bool | None:
    return None if outcome is None else not outcome


def _and(operands: tuple[Value, ...]) -> bool | None:
    outcomes = [truth(operand, launch=False) for operand in operands]
    return False if False in outcomes else (None if None in outcomes else True)


def _or(operands: tuple[Value, ...]) -> bool | None:
    outcomes = [truth(operand, launch=False) for operand in operands]
    return True if True in outcomes else (None if None in outcomes else False)


def _if(operands: tuple[Value, ...]) -> Value | None:
    outcome = truth(operands[0])
    return None if outcome is None else operands[1 if outcome else 2]


def _as_bool(operands: tuple[Value, ...]) -> str | None:
    text = text_of(operands[0])
    return None if text is None else ("True" if text.strip().lower() in ("true", "1", "yes", "on") else "False")


def _python(operands: tuple[Value, ...]) -> str | None:
    text = text_of(operands[0])
    if text is None:
        return None
    try:
        result = evaluate(text)
    except NotEvaluated:
        return None
    return str(result) if isinstance(result, (str, int, float, bool)) else None


def _case(method):
    def apply(operands: tuple[Value, ...]) -> str | None:
        text = text_of(operands[0])
        return None if text is None else method(text)

    return apply


_OPERATIONS = {
    "==": _equal,
    "!=": lambda operands: _not_of(_equal(operands)),
    "equals": _equals,
    "not-equals": lambda operands: _not_of(_equals(operands)),
    "and": _and,
    "or": _or,
    "not": lambda operands: _not_of(truth(operands[0], launch=False)),
    "if": _if,
    "as-bool": _as_bool,
    "python": _python,
    "lower": _case(str.lower),
    "upper": _case(str.upper),
    "strip": _case(str.strip),
    "capitalize": _case(str.capitalize),
    "title": _case(str.title),
}


def _choice(self: Resolver, value: Choice) -> Value:
    """The last option that holds; several when that is not known."""
    left: list[tuple[tuple[Condition, ...], Value]] = []
    for conditions, option in reversed(value.options):
        outcome = self.all_hold(conditions)
        if outcome is False:
            continue
        resolved = self.value(option)
        if outcome is True and not left:
            return resolved
        left.append((conditions, resolved))
        if outcome is True:
            break
    return Choice(tuple(reversed(left)), value.span)


def _list(self: Resolver, value: ListValue) -> Value:
    items: list[Value] = []
    for item in self.values(value.items):
        if not (isinstance(item, Choice) and not item.options):
            items.append(item)
    return ListValue(tuple(items), value.span, value.open)


def _dict(self: Resolver, value: DictValue) -> Value:
    return DictValue(self.pairs(value.items), value.span, value.open)


def _derived(self: Resolver, value: DerivedFile) -> Value:
    rewrites, root_key = self.optional(value.rewrites), self.optional(value.root_key)
    return DerivedFile(self.value(value.base), value.helper, rewrites, root_key, value.span)


def _file(self: Resolver, value: ParameterFile) -> Value:
    return ParameterFile(self.value(value.file), self.optional(value.allow_substs), value.span)


_RESOLVE: dict[type[Value], Callable[[Resolver, Any], Value]] = {
    Argument: _argument,
    Env: _env,
    Concat: _concat,
    PathJoin: _path,
    Operation: _operation,
    Choice: _choice,
    ListValue: _list,
    DictValue: _dict,
    DerivedFile: _derived,
    ParameterFile: _file,
    PackageShare: lambda self, value: PackageShare(self.value(value.package), value.span),
    PackagePrefix: lambda self, value: PackagePrefix(self.value(value.package), value.span),
    TypedValue: lambda self, value: TypedValue(self.value(value.value), value.type, value.span),
    Command: lambda self, value: Command(self.value(value.command), value.span),
}
