"""Branches of a chain of conditions that an earlier one takes in each case."""

from __future__ import annotations

import re
from collections.abc import Iterator
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
_CHOSEN = regex(r"^[ \t]*#[ \t]*(?:else|elif|endif)\b", re.M)
"""The compiler gets one of two parts alone."""


def repeated_branches(code: Code) -> Iterator[RepeatedBranch]:
    chains: dict[int, list[tuple[Node, str | None]]] = {}
    for clause in code.written.get("else", ()):
        later = next((each for each in clause.named_children if each.type == "if_statement"), None)
        if later is None:
            continue
        before = chains.pop(clause.id, None) or [(each, _condition(code, each)) for each in _first(clause)]
        condition = _condition(code, later)
        following = later.child_by_field_name("alternative")
        if following is not None:
            chains[following.id] = [(later, condition), *before[: CHAIN - 1]]
        if condition is None or _CHANGES.search(condition):
            continue
        earlier = next((each for each, asked in before if asked == condition), None)
        if earlier is not None:
            places = [each.child_by_field_name("condition") for each in (later, earlier)]
            first, second = (code.span(each) for each in places if each is not None)
            if not _CHOSEN.search(code.source.text, second.end, first.start):
                yield RepeatedBranch(first, second)


def _first(clause: Node) -> list[Node]:
    """The statement that begins a chain, of the first ``else`` in it."""
    return [clause.parent] if clause.parent is not None and clause.parent.type == "if_statement" else []


def _condition(code: Code, statement: Node | None) -> str | None:
    given = statement.child_by_field_name("condition") if statement is not None else None
    if given is None or given.child_by_field_name("initializer") is not None:
        return None
    return " ".join(code.text(given.child_by_field_name("value")).split())
