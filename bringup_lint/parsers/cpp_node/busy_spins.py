"""Loops of C++ nodes that spin_some() again and again, and never wait.

``spin_some`` returns at once when there is nothing to do, also with a duration, which is only its limit (rclcpp,
executor.cpp: it collects work with a timeout of 0)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import BusySpin
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

SPINS = "spin_some"
_BOUNDED = regex(r"[<>]|(?i:time|elapsed|deadline|count|tries|retr|wait|sleep|now)")
"""What of a condition ends a loop soon, or waits."""
_ASKS = frozenset({"ok", "load", "get", "is_canceled"})
"""Calls of a condition that return at once."""
_PASSIVE = regex(r"(?:RCLCPP_|std::c(?:out|err)\b|(?:std::)?(?:lock_guard|unique_lock|scoped_lock|shared_lock)\b)")
_LEAVES = frozenset({"break_statement", "return_statement"})


def busy_spins(code: Code) -> Iterator[BusySpin]:
    if SPINS not in code.source.text:
        return
    for loop in code.written.get("while", ()):
        condition, body = loop.child_by_field_name("condition"), loop.child_by_field_name("body")
        if body is None or not _is_quick(code, condition):
            continue
        spins = list(_spins(code, body))
        known = [each for each in spins if each is not None]
        if known and len(known) == len(spins) and condition is not None:
            yield BusySpin(code.span(known[0]), code.span(condition))


def _is_quick(code: Code, condition: Node | None) -> bool:
    """Whether a condition may hold for long, and waits for nothing."""
    if condition is None or _BOUNDED.search(code.text(condition).replace("->", ".")):
        return False
    return all(call is not None and call.name in _ASKS for call in map(code.call, _calls(condition)))


def _calls(top: Node) -> Iterator[Node]:
    todo = [top]
    while todo:
        node = todo.pop()
        if node.type == "call_expression":
            yield node
        todo += node.children


def _spins(code: Code, top: Node) -> Iterator[Node | None]:
    """The calls of spin_some() that a turn consists of; None for each part that does something else."""
    todo = [top]
    while todo:
        node = todo.pop()
        if node.type == "compound_statement":
            todo += reversed(node.named_children)
        elif node.type == "if_statement":
            yield from () if _only_leaves(code, node) else (None,)
        elif node.type not in ("comment", "continue_statement") and not _PASSIVE.match(code.text(node)):
            inner = node.named_children[0] if node.type == "expression_statement" and node.named_child_count else None
            call = code.call(inner) if inner is not None and inner.type == "call_expression" else None
            yield call.node if call is not None and call.name == SPINS else None


def _only_leaves(code: Code, choice: Node) -> bool:
    """Whether an ``if`` only asks a flag, and leaves the loop."""
    then = choice.child_by_field_name("consequence")
    inside = then.named_children if then is not None and then.type == "compound_statement" else [then]
    if choice.child_by_field_name("alternative") is not None or not inside or inside[-1] is None:
        return False
    return inside[-1].type in _LEAVES and _is_quick(code, choice.child_by_field_name("condition"))
