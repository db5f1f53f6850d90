"""Branches of a chain of conditions that an earlier one takes in each case."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import RepeatedBranch
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

CHAIN = 50
"""Conditions before one that are compared with it."""
_CHANGES = regex(r"\+\+|--|(?<![=!<>])=(?!=)|[\w>\])]\s{0,4}\(|//|/\*")
"""What may give another answer when it is asked again: a call, an assignment."""


def repeated_branches(code: Code) -> Iterator[RepeatedBranch]:
    for clause in code.written.get("else", ()):
        later = next((each for each in clause.named_children if each.type == "if_statement"), None)
        condition = _condition(code, later)
        if later is None or condition is None or _CHANGES.search(condition):
            continue
        for earlier in islice(_before(clause), CHAIN):
            if _condition(code, earlier) == condition:
                places = [each.child_by_field_name("condition") for each in (later, earlier)]
                first, second = (code.span(each) for each in places if each is not None)
                yield RepeatedBranch(first, second)
                break


def _before(clause: Node) -> Iterator[Node]:
    """The statements of a chain before its ``else``, the last one first."""
    outer = clause.parent
    while outer is not None and outer.type == "if_statement":
        yield outer
        inner = outer.parent
        outer = inner.parent if inner is not None and inner.type == "else_clause" else None


def _condition(code: Code, statement: Node | None) -> str | None:
    given = statement.child_by_field_name("condition") if statement is not None else None
    if given is None or given.child_by_field_name("initializer") is not None:
        return None
    return " ".join(code.text(given.child_by_field_name("value")).split())
