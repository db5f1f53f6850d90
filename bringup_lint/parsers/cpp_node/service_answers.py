"""Service callbacks of a C++ file that answer ``false``, which nobody reads."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import UnreadAnswer
from bringup_lint.model.node_source import Callback
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.parsers.cpp_node.waits import runs
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

ANSWERS = 50
"""``return false`` of one callback that are looked at."""
_SAYS = r"\b{}\s*(?:->|\.)\s*\w*(?:success|result|error|status|message)"
"""Fields by which a response tells of a failure, whatever their first value is."""
_FALSE = regex(r"return\s+false\s*;\Z")
_NO_WORD = regex(r"\W")
_BRANCHES = ("comment", "if_statement", "for_statement", "for_range_loop", "while_statement", "switch_statement")
"""Statements that may not run on the way, or that leave the function."""


def service_answers(code: Code, callbacks: list[Callback]) -> Iterator[UnreadAnswer]:
    """The first ``return false`` of each callback of a service, where the response says nothing of the failure."""
    services = [each for each in callbacks if each.role == "service" and each.name is not None]
    if not services:
        return
    bodies = Bodies(code)
    returns = [each for each in code.written.get("return", ()) if _FALSE.match(code.text(each))]
    for callback in services:
        body = bodies.of(callback)
        if body is None or code.text(body.child_by_field_name("type")) != "bool":
            continue
        response = _response(code, body)
        if response is None or re.search(_SAYS.format(re.escape(response)), code.text(body)):
            continue
        for node in islice((each for each in returns if runs(body, each)), ANSWERS):
            if not _is_told(code, body, node, response):
                has_data = re.search(rf"\b{re.escape(response)}\s*(?:->|\.)", code.text(body)) is not None
                yield UnreadAnswer(code.span(node), callback.span, str(callback.name), has_data)
                break


def _response(code: Code, body: Node) -> str | None:
    """The name of the last parameter."""
    declarator = body.child_by_field_name("declarator")
    given = declarator.child_by_field_name("parameters") if declarator is not None else None
    named = [each for each in given.named_children if each.type == "parameter_declaration"] if given is not None else []
    declared = code.text(named[-1].child_by_field_name("declarator")) if len(named) > 1 else ""
    return _NO_WORD.split(declared.strip())[-1] or None


def _is_told(code: Code, body: Node, node: Node, response: str) -> bool:
    """Whether something in the response is set on the way to a ``return``, or may be: by a plain statement before it,
    or by what the condition around it is given."""
    outer = node
    while outer.id != body.id and outer.parent is not None:
        before, outer = outer, outer.parent
        earlier = [each for each in outer.named_children if each.end_byte <= before.start_byte]
        plain = earlier if outer.type == "compound_statement" else [outer.child_by_field_name("condition")]
        texts = (code.text(each) for each in plain if each is None or each.type not in _BRANCHES)
        if any(re.search(rf"(?<!\(void\))\b{re.escape(response)}\b", "".join(text.split())) for text in texts):
            return True
    return False
