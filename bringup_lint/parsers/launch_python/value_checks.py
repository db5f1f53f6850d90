"""What the classes of launch refuse of the values that they get, by what a value should be."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from typing import Any

from bringup_lint.facts.ros.launch_calls import signature
from bringup_lint.model.launch import Action
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import Other
from bringup_lint.model.launch import Process
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.parsers.launch_python.objects import Description
from bringup_lint.parsers.launch_python.objects import Function
from bringup_lint.parsers.launch_python.objects import Handler
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.unperformed import is_object
from bringup_lint.parsers.launch_python.unperformed import is_substitution

Found = Iterator[tuple[str, Any]]
"""What a value should be, and the part of it that is something else."""


def _text(thing: Any) -> Found:
    if _is_number(thing):
        yield "text", thing
    elif isinstance(thing, Sequence):
        yield from (("text", item) for _, item in thing.items if _is_number(item) or _is_none(item))


def _words(thing: Any) -> Found:
    if _is_text(thing) and len(thing.value) > 1:
        yield "words", thing
    elif is_substitution(thing):
        yield "one", thing
    yield from _texts(thing)


def _program(thing: Any) -> Found:
    """A text as ``cmd=``: its first letter is the program. One of several words another rule finds."""
    if _is_text(thing) and len(thing.value) > 1 and " " not in thing.value:
        yield "letters", thing
    elif is_substitution(thing):
        yield "one", thing
    yield from _texts(thing)


def _texts(thing: Any) -> Found:
    for item in _items(thing):
        if _is_number(item) or _is_none(item):
            yield "text", item
        elif isinstance(item, Sequence):
            yield from _text(item)


def _values(thing: Any) -> Found:
    if isinstance(thing, Sequence) or _is_text(thing):
        yield "dictionary", thing
    if isinstance(thing, Mapping):
        yield from (("text", item) for _, item in thing.pairs() if _is_number(item) or _is_none(item))


def _pairs(thing: Any) -> Found:
    if isinstance(thing, Mapping):
        if thing.entries:
            yield "pairs", thing
        return
    for pair in _items(thing):
        inner = pair.plain() if isinstance(pair, Sequence) else None
        if inner is not None and len(inner) == 2 and (_is_number(inner[1]) or _is_none(inner[1])):
            yield "text", inner[1]
        elif (inner is not None and len(inner) != 2) or (_is_text(pair) and len(pair.value) != 2):
            yield "pair", pair


def _seconds(thing: Any) -> Found:
    if isinstance(thing, Literal) and isinstance(thing.value, int):
        yield "seconds", thing


def _truth(thing: Any) -> Found:
    if isinstance(thing, Literal) and not isinstance(thing.value, (bool, type(None))):
        yield "truth", thing


def _actions(thing: Any) -> Found:
    if isinstance(thing, Action):
        yield "actions", None
    for item in _items(thing):
        yield from not_action(item)


def not_action(thing: Any) -> Found:
    """What launch cannot visit."""
    if isinstance(thing, Sequence) and not isinstance(thing, Description):
        yield "action", thing
    elif isinstance(thing, Handler) and _handles(thing):
        yield "registered", thing
    elif isinstance(thing, (Literal, Mapping, Handler)) or is_substitution(thing):
        yield "visited", thing


def _reaction(thing: Any) -> Found:
    """What a handler gives launch to visit: actions, or a function that makes them."""
    if isinstance(thing, Sequence):
        for item in _items(thing):
            if _is_class(item) or any(not_action(item)):
                yield "reaction", item
    elif _is_class(thing) or (not _is_none(thing) and any(not_action(thing))):
        yield "reaction", thing


def _event(thing: Any) -> Found:
    if isinstance(thing, Action) and not isinstance(thing, Other):
        yield "event", None


def _process(thing: Any) -> Found:
    """The process that a handler waits for, or a function that knows it."""
    is_other = isinstance(thing, Action) and not isinstance(thing, (Process, Other))
    if is_other or isinstance(thing, (Sequence, Handler)) or _is_text(thing) or is_substitution(thing):
        yield "process", None


def _lifecycle(thing: Any) -> Found:
    is_node = isinstance(thing, Node) and thing.lifecycle
    if isinstance(thing, Action) and not is_node and not isinstance(thing, Other):
        yield "lifecycle", None


def _components(thing: Any) -> Found:
    if isinstance(thing, ComposableNode):
        yield "components", None
    yield from (("component", item) for item in _items(thing) if isinstance(item, Process))


def _function(thing: Any) -> Found:
    if isinstance(thing, (Sequence, Action)):
        yield "function", None
    elif _is_text(thing):
        yield "callable", thing


def _condition(thing: Any) -> Found:
    is_value = isinstance(thing, Literal) and not _is_none(thing)
    if is_value or isinstance(thing, (Sequence, Mapping, Function)) or is_substitution(thing):
        yield "condition", None


def _python_file(thing: Any) -> Found:
    if _end(thing).endswith((".xml", ".yaml", ".yml")):
        yield "script", thing


def _markup_file(thing: Any) -> Found:
    if _end(thing).endswith(".py"):
        yield "markup", thing


def _end(thing: Any) -> str:
    """The last text of a path; empty where it is not known."""
    last = thing
    if isinstance(thing, Sequence):
        last = next((item for _, item in reversed(thing.items)), None)
    elif isinstance(thing, (Concat, PathJoin)):
        last = thing.parts[-1] if thing.parts else None
    if last is not thing:
        return _end(last)
    return str(thing.value) if _is_text(thing) else ""


def _items(thing: Any) -> list[Any]:
    """What is in a list; nothing of anything else."""
    return [item for _, item in thing.items] if isinstance(thing, Sequence) else []


def _handles(handler: Handler) -> bool:
    """Whether this is an event handler, and no event."""
    return handler.name.startswith("On") or handler.name == "EventHandler"


def _is_class(thing: Any) -> bool:
    """Whether this is a class of launch itself and not what it makes."""
    return isinstance(thing, Symbol) and signature(thing.name) is not None


def kind_of(thing: Any) -> str:
    """What is given instead, in words; numbers, truth values and None as Python writes them."""
    if isinstance(thing, Literal):
        return "a text" if _is_text(thing) else repr(thing.value)
    if isinstance(thing, Handler):
        return "an event handler" if _handles(thing) else "an event"
    if is_object(thing):
        return "a launch configuration"
    return next((words for kind, words in _KINDS.items() if isinstance(thing, kind)), "a substitution")


def _is_text(thing: Any) -> bool:
    return isinstance(thing, Literal) and isinstance(thing.value, str)


def _is_number(thing: Any) -> bool:
    return isinstance(thing, Literal) and isinstance(thing.value, (bool, int, float))


def _is_none(thing: Any) -> bool:
    return isinstance(thing, Literal) and thing.value is None


_KINDS: dict[type, str] = {Sequence: "a list", Mapping: "a dictionary", Action: "an action", Symbol: "a class"}
CHECKS: dict[str, Callable[[Any], Found]] = {
    "text": _text,
    "texts": _texts,
    "words": _words,
    "values": _values,
    "pairs": _pairs,
    "seconds": _seconds,
    "truth": _truth,
    "actions": _actions,
    "function": _function,
    "condition": _condition,
    "program": _program,
    "reaction": _reaction,
    "event": _event,
    "process": _process,
    "lifecycle": _lifecycle,
    "components": _components,
    "python_file": _python_file,
    "markup_file": _markup_file,
}
