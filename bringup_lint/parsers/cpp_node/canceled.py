"""Goals that a C++ action server ends as canceled where nobody has asked for that."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Canceled
from bringup_lint.model.node_source import Callback
from bringup_lint.parsers.cpp_node.syntax import FUNCTIONS
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

MOST = 50
"""Calls of one file that are looked at."""
_ASKS = "is_canceling"
_MAY_KNOW = regex(r"(?i)cancel|stat(?:e|us)|result|code|\bok\b|success|reason|\breturned\b")
"""Words of conditions that may say that the cancellation was asked for."""
_ROLES = frozenset({"subscription", "service"})
_RESPONDS = regex(r"\bCancelResponse\b")
_DECIDES = "the question whether to cancel"
_CONDITIONS = ("if_statement", "while_statement", "for_statement", "do_statement")
_OTHERS = frozenset({"switch_statement", "case_statement", "catch_clause", "conditional_expression"})


def canceled(code: Code, callbacks: list[Callback]) -> Iterator[Canceled]:
    calls = list(islice(_calls(code), MOST))
    if not calls:
        return
    runs = dict(_runs(code, callbacks))
    for call in calls:
        asked = _asked(code, call.node, call.qualified[: -len("canceled")])
        if asked is not None:
            yield Canceled(code.span(call.node), code.span(asked), None)
            continue
        body = code.body_of(call.node)
        why = runs.get(body.id) if body is not None else None
        if body is not None and why is not None and not _may_know(code, call, body):
            yield Canceled(code.span(call.node), code.source.span(*_begin(code, body)), why, why == _DECIDES)


def _calls(code: Code) -> Iterator[Call]:
    return (call for call in code.calls if call.name == "canceled" and len(call.arguments) == 1)


def _runs(code: Code, callbacks: list[Callback]) -> Iterator[tuple[int, str]]:
    """The functions that run while a goal is executed, and what calls them."""
    bodies = Bodies(code)
    for callback in callbacks:
        body = bodies.of(callback) if callback.role in _ROLES else None
        if body is not None:
            yield body.id, f"a {callback.role}"
    for each in (*code.written.get("function", ()), *code.written.get("lambda", ())):
        if _RESPONDS.search(code.source.text[slice(*_begin(code, each))]):
            yield each.id, _DECIDES


def _begin(code: Code, function: Node) -> tuple[int, int]:
    """Where the head of a function is, up to its body."""
    body = function.child_by_field_name("body")
    return code.span(function).start, code.span(body if body is not None else function).start


def _may_know(code: Code, call: Call, body: Node) -> bool:
    """Whether a condition around a call, or anything in its function, may say that the goal is to be canceled."""
    text = code.text(body)
    if _ASKS in text or "CANCELING" in text:
        return True
    inside = (each for each in code.above(call.node) if body.start_byte < each.start_byte)
    return any(
        each.type in _OTHERS
        or (each.type in _CONDITIONS and _MAY_KNOW.search(code.text(each.child_by_field_name("condition"))) is not None)
        for each in inside
    )


def _asked(code: Code, call: Node, owner: str) -> Node | None:
    """The condition before the call after which the goal is surely not one that is to be canceled."""
    if f"{_ASKS}()" not in code.source.text:
        return None
    found, conditions, inner = None, 0, call
    for outer in code.above(call):
        if outer.type in FUNCTIONS:
            return found if conditions else None
        if outer.type in _OTHERS:
            return None
        if outer.type in _CONDITIONS:
            conditions += outer.type == "if_statement"
            condition = code.text(outer.child_by_field_name("condition"))
            if outer.type == "if_statement" and _MAY_KNOW.search(condition.replace("this->", "")):
                return None
        if outer.type == "compound_statement" and found is None:
            found = _branch(code, outer, inner, owner)
        inner = outer
    return None


def _branch(code: Code, block: Node, until: Node, owner: str) -> Node | None:
    """The condition of an ``if`` before a statement of a block that asks for the cancellation, and returns."""
    for each in (child for child in block.named_children if child.start_byte < until.start_byte):
        if each.type != "if_statement" or each.child_by_field_name("alternative") is not None:
            continue
        condition = each.child_by_field_name("condition")
        body = each.child_by_field_name("consequence")
        last = body.named_children[-1] if body is not None and body.named_child_count else None
        if "".join(code.text(condition).split()) == f"({owner}{_ASKS}())" and last is not None:
            if last.type == "return_statement" or (body is not None and body.type == "return_statement"):
                return condition
    return None
