"""Goals that a C++ action server ends as canceled where nobody has asked for that."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Canceled
from bringup_lint.parsers.cpp_node.syntax import FUNCTIONS
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_ASKS = "is_canceling"
_MAY_KNOW = regex(r"(?i)cancel|stat(?:e|us)|result|code|\bok\b|success|reason|\breturned\b")
"""Words of conditions that may say that the cancellation was asked for."""
_CONDITIONS = ("if_statement", "while_statement", "for_statement", "do_statement")
_OTHERS = frozenset({"switch_statement", "case_statement", "catch_clause", "conditional_expression"})


def canceled(code: Code) -> Iterator[Canceled]:
    if f"{_ASKS}()" not in code.source.text:
        return
    for call in code.calls:
        if call.name == "canceled" and len(call.arguments) == 1:
            asked = _asked(code, call.node, call.qualified[: -len("canceled")])
            if asked is not None:
                yield Canceled(code.span(call.node), code.span(asked))


def _asked(code: Code, call: Node, owner: str) -> Node | None:
    """The condition before the call after which the goal is surely not one that is to be canceled."""
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
