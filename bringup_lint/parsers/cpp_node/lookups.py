"""Transforms that callbacks of a C++ file look up without catching what tf2 throws."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Lookup
from bringup_lint.model.node_source import Callback
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies

if TYPE_CHECKING:
    from tree_sitter import Node

_ASKS = frozenset({"canTransform", "waitForTransform"})
_LOOKUP = "lookupTransform"


def lookups(code: Code, callbacks: list[Callback]) -> Iterator[Lookup]:
    """The lookups in the callbacks themselves: a function that they call may be called within a ``try``."""
    if _LOOKUP not in code.source.text:
        return
    bodies = Bodies(code)
    seen: set[int] = set()
    for callback in callbacks:
        body = bodies.of(callback)
        if body is None or body.id in seen:
            continue
        seen.add(body.id)
        calls = list(bodies.own(body))
        if any(call.name in _ASKS for call in calls):
            continue
        for call in calls:
            if call.name == _LOOKUP and "buffer" in call.qualified.lower() and not _is_tried(body, call.node):
                yield Lookup(code.span(call.node), callback)


def _is_tried(body: Node, node: Node) -> bool:
    outer = node.parent
    while outer is not None and outer.id != body.id:
        if outer.type == "try_statement":
            return True
        outer = outer.parent
    return False
