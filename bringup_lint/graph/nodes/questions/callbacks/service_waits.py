"""Waits for a service or an action server that may last forever."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.callback_code import code_of
from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

_WAITS = ("wait_for_service", "wait_for_server")
_LOGS = frozenset({"info", "warn", "warning", "error", "debug", "fatal"})


class Waiting(NamedTuple):
    """``wait_for_service()`` or ``wait_for_server()`` without a time-out, in the constructor or in a callback."""

    call: ast.Call
    service: str | None
    where: str
    logged: bool
    """A message right before it says what the node waits for."""


def waits(ending: Ending, cls: NodeClass) -> Iterator[Waiting]:
    """The waits for a service that may last forever."""
    if not any(word in source.text for source in {each.source for each in cls.lineage} for word in _WAITS):
        return
    init = cls.methods.get("__init__")
    places = [("__init__", body_of(init.node))] if init is not None else []
    places += [code_of(ending, cls, callback) for callback in cls.callbacks]
    seen: set[ast.AST] = set()
    for where, body in places:
        calls = [node for node in reached(ending.syntax, body, cls) if isinstance(node, ast.Call) and _is_wait(node)]
        bounded: dict[str, int] = {}
        """The first line of each wait with a time-out."""
        for call in calls:
            if call.args or call.keywords:
                bounded[_client(call)] = min(call.lineno, bounded.get(_client(call), call.lineno))
        for call in calls:
            is_found = bounded.get(_client(call), call.lineno) < call.lineno
            if is_found or call.args or call.keywords or call in seen:
                continue
            kept = [each for each in cls.all_endpoints if each.attribute == _client(call)]
            found = [each for each in kept if each.role.endswith("client")]
            if found:
                seen.add(call)
                yield Waiting(call, found[0].name, where, _is_announced(ending.syntax, call))


def _is_wait(call: ast.Call) -> bool:
    return isinstance(call.func, ast.Attribute) and call.func.attr in _WAITS


def _client(wait: ast.Call) -> str:
    """What a wait is called on."""
    return written(wait.func.value) if isinstance(wait.func, ast.Attribute) else ""


def _is_announced(syntax: Syntax, call: ast.Call) -> bool:
    """Whether one of the two statements before a call logs or prints something."""
    for outer, _ in syntax.within(call):
        if not isinstance(outer, ast.stmt):
            continue
        above = next(syntax.above(outer), None)
        block = getattr(*above) if above is not None else None
        if isinstance(block, list):
            at = block.index(outer)
            return any(_is_message(each) for each in own_calls(block[max(0, at - 2) : at]))
    return False


def _is_message(call: ast.Call) -> bool:
    function = call.func
    if isinstance(function, ast.Name):
        return function.id == "print"
    return isinstance(function, ast.Attribute) and function.attr in _LOGS
