"""From the evaluator's objects to the model: values, texts, pairs and actions."""

from __future__ import annotations

from copy import copy
from typing import Any

from bringup_lint.model.launch import Action
from bringup_lint.model.launch import Other
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import is_value
from bringup_lint.parsers.launch_python.budget import bounded
from bringup_lint.parsers.launch_python.budget import concat
from bringup_lint.parsers.launch_python.objects import Guards
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.source import Span

DEPTH = 16


def span_of(thing: Any, fallback: Span) -> Span:
    return getattr(thing, "span", fallback)


def is_none(thing: Any) -> bool:
    return isinstance(thing, Literal) and thing.value is None


def value(state: State, thing: Any, depth: int = 0) -> Value:
    """The model value of an object; Unknown when it has none."""
    if isinstance(thing, (Literal, Argument)):
        return thing
    if depth > DEPTH:
        return Unknown("nested too deeply", span_of(thing, state.file.source.whole))
    if isinstance(thing, Sequence):
        state.tick(len(thing.items))
        items = tuple(conditional(state, guards, value(state, item, depth + 1)) for guards, item in thing.items)
        return ListValue(items, thing.span, thing.open)
    if isinstance(thing, Mapping):
        pairs = thing.pairs()
        state.tick(len(pairs))
        entries = tuple((value(state, key, depth + 1), value(state, item, depth + 1)) for key, item in pairs)
        return DictValue(entries, thing.span, thing.open)
    if isinstance(thing, Options):
        state.tick(len(thing.options))
        options = tuple((guards, value(state, option, depth + 1)) for guards, option in thing.options)
        return bounded(Choice(options, thing.span))
    if is_value(thing):
        return thing
    return Unknown("not a value", span_of(thing, state.file.source.whole))


def conditional(state: State, guards: Guards, inner: Value) -> Value:
    return Choice(((guards, inner),), inner.span) if guards else inner


def text(state: State, thing: Any) -> Value:
    """The value where launch takes a substitution or a list of them: a list is one text."""
    if isinstance(thing, Sequence):
        items = thing.plain()
        if items is None:
            return Unknown("conditional text", thing.span)
        if not items:
            return Literal("", thing.span)
        return concat([text(state, item) for item in items], thing.span)
    return value(state, thing)


def optional_text(state: State, thing: Any) -> Value | None:
    """None for an absent argument and for ``None``."""
    return None if thing is None or is_none(thing) else text(state, thing)


def pairs(state: State, thing: Any) -> tuple[tuple[tuple[Value, Value], ...], bool]:
    """Pairs from a dictionary or an iterable of tuples, and whether there may be more of them."""
    if thing is None or is_none(thing):
        return (), False
    if isinstance(thing, Mapping):
        return tuple((text(state, key), text(state, item)) for key, item in thing.pairs()), thing.open
    if not isinstance(thing, Sequence):
        return (), True
    result = []
    more = thing.open
    for guards, item in thing.items:
        inner = item.plain() if isinstance(item, Sequence) else None
        if inner is None or len(inner) != 2:
            more = True
            continue
        result.append((text(state, inner[0]), conditional(state, guards, text(state, inner[1]))))
    return tuple(result), more


def values(state: State, thing: Any) -> tuple[Value, ...]:
    """The items of a list, each as launch's text; a lone value counts as a list of one."""
    if thing is None or is_none(thing):
        return ()
    if isinstance(thing, Sequence):
        result = [conditional(state, guards, text(state, item)) for guards, item in thing.items]
        if thing.open:
            result.append(Unknown("more items than are known", thing.span))
        return tuple(result)
    if isinstance(thing, Options):
        return (value(state, thing),)
    return (text(state, thing),)


def sources(state: State, thing: Any) -> tuple[Value, ...]:
    """A ``parameters=`` list: dictionaries stay dictionaries, everything else names a file."""
    if thing is None or is_none(thing):
        return ()
    if not isinstance(thing, Sequence):
        return (value(state, thing),)
    result = []
    for guards, item in thing.items:
        inner = value(state, item) if isinstance(item, (Mapping, Options)) else text(state, item)
        result.append(conditional(state, guards, inner))
    if thing.open:
        result.append(Unknown("more items than are known", thing.span))
    return tuple(result)


def under(action: Action, guards: Guards) -> Action:
    """The action with the conditions of its place."""
    if not guards:
        return action
    placed = copy(action)
    placed.conditions = guards + action.conditions
    return placed


def actions(state: State, thing: Any, depth: int = 0) -> tuple[Action, ...]:
    """The actions in a list, a description, or the result of a function."""
    if thing is None or is_none(thing):
        return ()
    if isinstance(thing, Action):
        return (thing,)
    where = span_of(thing, state.file.source.whole)
    if depth > DEPTH:
        return (Other(span=where, why="nested too deeply"),)
    if isinstance(thing, Sequence):
        parts = list(thing.items)
        if thing.open:
            parts.append(((), Unknown("more actions than are known", where)))
    elif isinstance(thing, Options):
        parts = thing.options
    elif isinstance(thing, Mapping) and not thing.pairs() and not thing.open:
        return ()
    else:
        return (Other(span=where, why=thing.why if isinstance(thing, Unknown) else "not an action"),)
    state.tick(len(parts))
    result: list[Action] = []
    for guards, item in parts:
        result.extend(under(action, guards) for action in actions(state, item, depth + 1))
        state.tick(len(result) // 100)
    return tuple(result)
