"""Transforms for which a callback waits while the executor that receives them waits for the callback."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.callbacks.transforms import hears_by_own_executor
from bringup_lint.graph.nodes.questions.callbacks.transforms import is_lookup
from bringup_lint.graph.nodes.sources.callback_code import code_of
from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_node.values import argument
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_ROLES = ("subscription", "timer", "service", "action")
_AHEAD = regex(r"\bstamp\b|\.now\(\)")
_SHORTEST = 0.05
"""Seconds of a wait that nobody notices."""


class StarvedWait(NamedTuple):
    """A lookup with a timeout that nothing can end before its time."""

    file: NodeSource
    call: ast.Call
    callback: Callback
    name: str
    """The method or function that is the callback."""
    seconds: float
    is_ahead: bool
    """It asks for the time of a message or of the clock, and the newest transform is nearly always older than these."""


def starved_waits(nodes: Nodes) -> Iterator[StarvedWait]:
    """The lookups with a timeout in callbacks of one executor with one thread, which alone hears the transforms."""
    for file, cls in nodes.node_classes:
        ending = nodes.ending(file)
        if nodes.threads(cls) == "one" and hears_by_own_executor(ending, cls):
            yield from _starved(ending, cls)


def _starved(ending: Ending, cls: NodeClass) -> Iterator[StarvedWait]:
    seen: set[ast.AST] = set()
    for callback in cls.callbacks:
        if callback.role not in _ROLES:
            continue
        name, body = code_of(ending, cls, callback)
        for node in reached(ending.syntax, body, cls):
            if isinstance(node, ast.Call) and node not in seen and is_lookup(ending, node):
                seen.add(node)
                seconds = _timeout(node)
                if seconds > _SHORTEST:
                    yield StarvedWait(ending.file, node, callback, name, seconds, _is_ahead(node))


def _timeout(lookup: ast.Call) -> float:
    """The timeout of ``lookup_transform(target, source, time, timeout)`` and of ``transform(object, target, timeout)``,
    in seconds; 0 without one and when it is not written there as a number."""
    at = 2 if isinstance(lookup.func, ast.Attribute) and lookup.func.attr == "transform" else 3
    value = argument(lookup, at, "timeout")
    if not isinstance(value, ast.Call) or not written(value.func).endswith("Duration"):
        return 0.0
    return sum(_number(each) for each in value.keywords)


def _number(part: ast.keyword) -> float:
    if not isinstance(part.value, ast.Constant) or not isinstance(part.value.value, (int, float)):
        return 0.0
    return {"seconds": 1.0, "nanoseconds": 1e-9}.get(part.arg or "", 0.0) * part.value.value


def _is_ahead(lookup: ast.Call) -> bool:
    value = argument(lookup, 2, "time")
    return value is not None and _AHEAD.search(written(value)) is not None
