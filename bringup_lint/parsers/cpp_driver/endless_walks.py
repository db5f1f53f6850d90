"""Walks through linked lists that stay at an entry which they leave out."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import EndlessWalk
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

WALKS = regex(r"=\s{0,4}\w{1,80}\s{0,4}->\s{0,4}\w{0,40}next\w{0,20}\s{0,4};")
_CONDITION = regex(
    r"\(\s{0,4}(?:(?:nullptr|NULL)\s{0,4}!=\s{0,4})?(\w{1,80})(?:\s{0,4}!=\s{0,4}(?:nullptr|NULL|0))?\s{0,4}\)\Z"
)
_INNER = frozenset("while_statement for_statement for_range_loop do_statement lambda_expression".split())
"""What a ``continue`` belongs to instead."""


def endless_walks(code: Code) -> Iterator[EndlessWalk]:
    """``while (p) { ...continue...; p = p->next; }``: the first ``continue`` before the one step of each loop."""
    for loop in code.written.get("while", ()):
        condition = _CONDITION.match(code.text(loop.child_by_field_name("condition")))
        body = loop.child_by_field_name("body")
        if condition is None or body is None or body.type != "compound_statement":
            continue
        step = _step(code, body, condition[1])
        if step is not None:
            skips = next((each for each in _continues(body) if each.start_byte < step.start_byte), None)
            if skips is not None:
                yield EndlessWalk(code.span(skips), code.span(step), condition[1])


def _step(code: Code, body: Node, name: str) -> Node | None:
    """The statement of a loop itself that alone gives its variable a value, the next entry."""
    word = re.escape(name)
    changed = rf"\b{word}\s*=(?!=)|&\s*{word}\b(?!\s*->)"
    for each in body.named_children:
        step = each.named_children[0] if each.type == "expression_statement" and each.named_children else None
        if step is not None and step.type == "assignment_expression" and code.text(step).startswith(name):
            is_next = re.match(rf"{word}\s*=\s*{word}\s*->\s*\w{{0,40}}next\w{{0,40}}\Z", code.text(step)) is not None
            is_only = len(re.findall(changed, blanked(code.text(body)))) == 1
            return step if is_next and is_only else None
    return None


def _continues(body: Node) -> Iterator[Node]:
    todo = [body]
    while todo:
        node = todo.pop()
        if node.type == "continue_statement":
            yield node
        elif node.type not in _INNER:
            todo += reversed(node.named_children)
