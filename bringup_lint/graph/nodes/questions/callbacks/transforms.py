"""Transforms that a callback asks for without handling that there is none, or a constructor before any can come."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.callback_code import code_of
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import children
from bringup_lint.model.python import is_self
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

DEPTH = 4
_LISTENERS = ("tf2_ros.TransformListener", "tf2_ros.transform_listener.TransformListener")
_RUNS = regex(
    r"spin_thread|[Tt]hread|spin_once|spin_some|spin_until|(?<!\brclpy)\.spin\b|concurrent\.futures|\bset_transform"
)
"""What may run the subscriptions of a listener while the constructor goes on, or fill its buffer in another way."""
_WAITS = regex(r"wait|spin")
_LOOKUPS = frozenset({"lookup_transform", "lookup_transform_full"})
_ASKS = frozenset({"can_transform", "wait_for_transform_async", "can_transform_full"})
_ROLES = ("subscription", "timer", "service", "client")
"""Callbacks whose exceptions end the spin; what an action raises only aborts its goal (rclpy, action/server.py)."""


class Unhandled(NamedTuple):
    call: ast.Call
    callback: Callback
    name: str
    """The function that asks."""


def unhandled_transforms(ending: Ending, cls: NodeClass) -> Iterator[Unhandled]:
    """The lookups outside every ``try`` between them and the callback; each once."""
    seen: set[ast.AST] = set()
    entered: dict[ast.AST, int] = {}
    for callback in cls.callbacks:
        if callback.role not in _ROLES:
            continue
        name, body = code_of(ending, cls, callback)
        for call, function in _unguarded(ending, cls, body, name, DEPTH, entered):
            if call not in seen:
                seen.add(call)
                yield Unhandled(call, callback, function)


def early_lookups(ending: Ending, cls: NodeClass) -> list[ast.Call]:
    """The lookups in the constructor of a node on whose own executor its listener depends; none where a handler goes on
    without the transform."""
    method = cls.methods.get("__init__")
    if method is None or not hears_by_own_executor(ending, cls):
        return []
    body = body_of(method.node)
    calls = list(own_calls(body))
    asks = any(_method(each) in _ASKS for each in calls)
    waits = any(_WAITS.search(written(each.func)) for each in calls)
    return [] if asks or waits else [call for call in _outside_try(body) if is_lookup(ending, call)]


def hears_by_own_executor(ending: Ending, cls: NodeClass) -> bool:
    """Whether the transforms of a node come in by the executor that runs its callbacks, as far as its file shows."""
    if ending.file.source.matches(_RUNS):
        return False
    made = [call for name in _LISTENERS for call in ending.syntax.named.get(name, [])]
    given = [value for call in made for value in (*call.args[1:2], *(each.value for each in call.keywords))]
    return any(map(is_self, given)) and all(ending.syntax.class_of(call) is cls for call in made)


def _unguarded(
    ending: Ending, cls: NodeClass, body: list[ast.AST], name: str, depth: int, entered: dict[ast.AST, int]
) -> Iterator[tuple[ast.Call, str]]:
    calls = list(_outside_try(body))
    if any(_method(call) in _ASKS for call in calls):
        return
    for call in calls:
        if is_lookup(ending, call):
            yield call, name
        elif depth:
            for function, owner in called(ending.syntax, call, cls):
                if entered.get(function, 0) < depth and (owner is None or owner.source is cls.source):
                    entered[function] = depth
                    inner: list[ast.AST] = list(function.body)
                    yield from _unguarded(ending, cls, inner, function.name, depth - 1, entered)


def _outside_try(body: list[ast.AST]) -> Iterator[ast.Call]:
    """The calls that no exception handler of the same function surrounds."""
    stack = list(reversed(body))
    while stack:
        node = stack.pop()
        if isinstance(node, (*FUNCTIONS, ast.ClassDef)):
            continue
        if isinstance(node, ast.Call):
            yield node
        inner = children(node)
        if isinstance(node, ast.Try) and node.handlers:
            inner = [each for each in inner if each not in node.body]
        stack.extend(reversed(inner))


def _method(call: ast.Call) -> str:
    return call.func.attr if isinstance(call.func, ast.Attribute) else ""


def is_lookup(ending: Ending, call: ast.Call) -> bool:
    """Whether a call asks the buffer of a listener for a transform."""
    name = _method(call)
    if not isinstance(call.func, ast.Attribute) or name not in (*_LOOKUPS, "transform"):
        return False
    owner = ending.file.named(call.func.value, ending.syntax.function(call)) or ""
    if owner.startswith("tf2_ros.") and owner.endswith("Buffer"):
        return True
    return name in _LOOKUPS and "buffer" in written(call.func.value).lower()
