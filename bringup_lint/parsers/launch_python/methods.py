"""Methods of strings, lists, dictionaries, paths, launch configurations and launch descriptions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bringup_lint.model.launch_values import VALUE_TYPES
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.containers import append
from bringup_lint.parsers.launch_python.containers import extend
from bringup_lint.parsers.launch_python.containers import in_order
from bringup_lint.parsers.launch_python.containers import merge
from bringup_lint.parsers.launch_python.containers import presence
from bringup_lint.parsers.launch_python.containers import put
from bringup_lint.parsers.launch_python.functions import join_path
from bringup_lint.parsers.launch_python.functions import path
from bringup_lint.parsers.launch_python.objects import Bound
from bringup_lint.parsers.launch_python.objects import Context
from bringup_lint.parsers.launch_python.objects import Description
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Placed
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.operators import configuration
from bringup_lint.parsers.launch_python.operators import joined
from bringup_lint.parsers.launch_python.operators import performed
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.state import relative
from bringup_lint.parsers.launch_python.truth import unless
from bringup_lint.parsers.launch_python.unperformed import note_object
from bringup_lint.source import Located
from bringup_lint.source import Span

_CASE: dict[str, Callable[[str], str]] = {
    "lower": str.lower,
    "upper": str.upper,
    "strip": str.strip,
    "capitalize": str.capitalize,
    "title": str.title,
}
_SYMBOLIC = frozenset(("lower", "upper", "strip", "capitalize", "title"))
_SAME_PATH = frozenset(("resolve", "absolute", "as_posix", "expanduser", "__str__"))
_EXISTS = frozenset(("exists", "is_file", "is_dir"))


def method(state: State, bound: Bound, args: Arguments) -> Any:
    owner, name = bound.owner, bound.name
    if isinstance(owner, Description) and name in ("add_action", "add_entity"):
        append(state, owner, args.need("action", 0))
        return Literal(None, args.span)
    if isinstance(owner, Sequence):
        return _list(state, owner, name, args)
    if isinstance(owner, Mapping):
        return _dict(state, owner, name, args)
    if isinstance(owner, Bound):
        return _nested(state, owner, name, args)
    if isinstance(owner, Context):
        return _context(state, name, args)
    if isinstance(owner, Placed) and name == "evaluate":
        outcome = _outcome(owner.condition.predicate, args.span)
        return outcome if owner.condition.wanted else _not(outcome, args.span)
    if isinstance(owner, Options):
        cases = [(own, method(state, Bound(option, name, bound.span), args)) for own, option in owner.options[:16]]
        return Options(cases, args.span)
    if isinstance(owner, VALUE_TYPES):
        return _value(state, owner, name, args)
    return Unknown(f"method {name}", args.span)


def _outcome(predicate: Value, span: Span) -> Value:
    """The bool that ``evaluate(context)`` gives."""
    return Operation("as-bool", (perform(predicate),), span) if isinstance(predicate, Argument) else predicate


def _not(predicate: Value, span: Span) -> Value:
    return Operation("not", (predicate,), span)


def _list(state: State, owner: Sequence, name: str, args: Arguments) -> Any:
    none = Literal(None, args.span)
    if name in ("append", "add", "add_action"):
        append(state, owner, args.need("object", 0))
    elif name in ("extend", "update"):
        extend(state, owner, args.need("iterable", 0), relative(state.guards, owner.base))
    elif name == "insert":
        _insert(state, owner, args)
    elif name == "copy":
        return Sequence(list(owner.items), args.span, state.guards, owner.open)
    elif name in ("index", "count", "__len__"):
        return Unknown(f"method {name}", args.span)
    elif name == "remove":
        _remove(state, owner, args.need("value", 0))
    elif name == "reverse" and not owner.open and not relative(state.guards, owner.base):
        owner.items.reverse()
    elif name == "sort" and not args.keywords and not relative(state.guards, owner.base):
        in_order(owner)
    elif name == "pop" and not state.guards and owner.plain():
        index = args.get("index", 0)
        at = -1 if index is None else index.value if isinstance(index, Literal) else None
        if type(at) is int and -len(owner.items) <= at < len(owner.items):
            return owner.items.pop(at)[1]
        owner.open = True
        return Unknown("pop", args.span)
    else:
        owner.open = True
        return Unknown(f"method {name}", args.span)
    return none


def _insert(state: State, owner: Sequence, args: Arguments) -> None:
    index = args.get("index", 0)
    at = index.value if isinstance(index, Literal) and type(index.value) is int else 0
    owner.items.insert(at, (relative(state.guards, owner.base), args.need("object", 1)))


def _remove(state: State, owner: Sequence, thing: Any) -> None:
    """Under a condition the item stays where that does not hold; an unknown item may be any of them."""
    guards = relative(state.guards, owner.base)
    for at, (own, item) in enumerate(owner.items):
        same = isinstance(item, Literal) and isinstance(thing, Literal) and item.value == thing.value
        if not (item is thing or same):
            continue
        if guards:
            owner.items[at] = ((*own, unless(guards)), item)
        else:
            del owner.items[at]
        return


def _dict(state: State, owner: Mapping, name: str, args: Arguments) -> Any:
    if name in ("items", "keys", "values"):
        state.tick(len(owner.entries) + len(owner.others))
        there = [presence(item) for _, item in owner.pairs()]
        if name == "items":
            things = [Sequence([((), key), ((), item)], args.span, state.guards) for key, item in owner.pairs()]
        else:
            things = [pair[name == "values"] for pair in owner.pairs()]
        items = [(own, thing) for own, thing in zip(there, things) if own is not None]
        return Sequence(items, owner.span, state.guards, owner.open or None in there)
    if name in ("get", "pop", "setdefault"):
        return _entry(state, owner, name, args)
    if name == "copy":
        return Mapping(args.span, dict(owner.entries), list(owner.others), owner.open, state.guards)
    if name == "update":
        for other in args.positional:
            merge(state, owner, other)
        for key, value in args.keywords.items():
            put(state, owner, Literal(Located(key, args.span), args.span), value)
        return Literal(None, args.span)
    owner.open = True
    return Unknown(f"method {name}", args.span)


def _entry(state: State, owner: Mapping, name: str, args: Arguments) -> Any:
    key = args.get("key", 0)
    default = args.get("default", 1)
    fallback = Literal(None, args.span) if default is None else default
    note_object(state, "looked-up", key, args.span)
    if not isinstance(key, Literal) or owner.open or owner.others:
        return Unknown("key", args.span)
    if key.value in owner.entries:
        found = owner.entries[key.value][1]
        if presence(found) != ():
            found = Options([((), fallback), *found.options], args.span)
        if name == "pop" and relative(state.guards, owner.base):
            owner.open = True
        elif name == "pop":
            del owner.entries[key.value]
    else:
        found = fallback
    if name == "setdefault":
        put(state, owner, key, found)
    return found


def _nested(state: State, owner: Bound, name: str, args: Arguments) -> Any:
    """``context.launch_configurations.get(...)`` and the entities of a description."""
    if owner.name == "launch_configurations":
        if name == "get":
            return configuration(state, args.get("key", 0), args.get("default", 1), args.span)
        state.file.reads_all = True
        return Unknown("launch configurations", args.span)
    if owner.name in ("entities", "describe_sub_entities") and isinstance(owner.owner, Description):
        return _list(state, owner.owner, name, args)
    return Unknown(f"method {name}", args.span)


def _context(state: State, name: str, args: Arguments) -> Any:
    if name == "perform_substitution":
        return perform(args.need("sub", 0))
    if name == "get_locals_as_dict":
        state.file.reads_all = True
    return Unknown(f"context.{name}", args.span)


def perform(thing: Any) -> Any:
    """What ``perform(context)`` gives: the same value as plain text."""
    if isinstance(thing, Argument):
        return Argument(thing.name, thing.default, thing.span, performed=True)
    return thing


def _value(state: State, owner: Value, name: str, args: Arguments) -> Any:
    if name == "perform":
        return perform(owner)
    if name == "find" and isinstance(owner, PackageShare):
        return owner
    if name in _EXISTS:
        return Operation("exists", (owner,), args.span)
    if isinstance(owner, Literal) and isinstance(owner.value, str):
        return _string(state, owner, name, args)
    if name in ("joinpath", "__truediv__"):
        return join_path(state, [owner, *(path(state, thing) for thing in args.positional)], args.span)
    if name in _SAME_PATH:
        return owner
    if name in _SYMBOLIC and not args.positional:
        if isinstance(owner, (Argument, Env, Operation)):
            return budget.bounded(Operation(name, (owner,), args.span))
    return Unknown(owner.why if isinstance(owner, Unknown) else f"method {name}", args.span)


def _string(state: State, owner: Literal, name: str, args: Arguments) -> Any:
    text, span = str(owner.value), args.span
    if name == "format":
        return _format(state, text, args)
    if name == "join":
        return _join(state, text, args)
    if name in _CASE and not args.positional:
        return Literal(Located(_CASE[name](text), owner.span), owner.span)
    words = [thing.value for thing in args.positional if isinstance(thing, Literal) and isinstance(thing.value, str)]
    if len(words) != len(args.positional) or args.keywords:
        return Unknown(f"method {name}", span)
    words = [str(word) for word in words]
    if name in ("startswith", "endswith") and len(words) == 1:
        return Literal(getattr(text, name)(words[0]), span)
    if name in ("split", "rsplit", "splitlines") and len(words) <= 1 and "" not in words:
        parts = getattr(text, name)(*words)
        state.tick(len(parts))
        return Sequence([((), Literal(Located(part, span), span)) for part in parts], span, state.guards)
    if name in ("strip", "lstrip", "rstrip") and len(words) <= 1:
        return Literal(Located(getattr(text, name)(*words), span), span)
    if name == "replace" and len(words) == 2 and len(text) * (len(words[1]) + 1) <= budget.LENGTH:
        return Literal(Located(text.replace(words[0], words[1]), span), span)
    return Unknown(f"method {name}", span)


def _format(state: State, pattern: str, args: Arguments) -> Any:
    from string import Formatter

    parts: list[Value] = []
    automatic = 0
    try:
        fields = list(Formatter().parse(pattern))
    except ValueError:
        return Unknown("format", args.span)
    for before, field, spec, conversion in fields:
        if before:
            parts.append(Literal(Located(before, args.span), args.span))
        if field is None:
            continue
        if field == "":
            field, automatic = str(automatic), automatic + 1
        thing = args.get(field, int(field) if field.isdecimal() and len(field) < 6 else None)
        if thing is None or spec or conversion:
            return Unknown("format", args.span)
        parts.append(performed(state, thing, args.span))
    return joined(parts, args.span)


def _join(state: State, separator: str, args: Arguments) -> Any:
    thing = args.need("iterable", 0)
    items = thing.plain() if isinstance(thing, Sequence) else None
    if items is None:
        return Unknown("join", args.span)
    parts: list[Value] = []
    for item in items:
        if parts and separator:
            parts.append(Literal(Located(separator, args.span), args.span))
        parts.append(performed(state, item, args.span))
    return joined(parts, args.span) if parts else Literal(Located("", args.span), args.span)
