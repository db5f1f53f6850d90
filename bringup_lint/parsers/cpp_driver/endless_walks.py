"""Walks through linked lists that stay at an entry which they leave out."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import EndlessWalk
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
        skips = [each for each in _continues(body) if step is not None and each.start_byte < step.start_byte]
        if step is not None and skips:
            yield EndlessWalk(code.span(skips[0]), code.span(step), condition[1])


def _step(code: Code, body: Node, name: str) -> Node | None:
    """The statement of a loop itself that alone gives its variable a value, the next entry."""
    assigned = [
        each
        for each in code.written.get("assignment", ())
        if body.start_byte < each.start_byte < body.end_byte and code.text(each.child_by_field_name("left")) == name
    ]
    if len(assigned) != 1 or assigned[0].parent is None or assigned[0].parent.parent != body:
        return None
    right = "".join(code.text(assigned[0].child_by_field_name("right")).split())
    is_next = re.match(rf"{re.escape(name)}->\w*next\w*\Z", right) is not None
    return assigned[0] if is_next and not _is_given_away(code, body, name) else None


def _is_given_away(code: Code, body: Node, name: str) -> bool:
    """Whether a loop hands out the address of its variable."""
    return re.search(rf"&\s*{re.escape(name)}\b(?!\s*->)", code.text(body)) is not None


def _continues(body: Node) -> Iterator[Node]:
    todo = [body]
    while todo:
        node = todo.pop()
        if node.type == "continue_statement":
            yield node
        elif node.type not in _INNER:
            todo += reversed(node.named_children)
