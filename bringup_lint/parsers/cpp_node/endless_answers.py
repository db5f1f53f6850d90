"""Answers of services and actions that a C++ file waits for without a timeout."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import EndlessAnswer
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

ASKS = ("async_send_request", "async_send_goal", "async_cancel_goal", "async_get_result")
WAITS = 200
"""Waits of one file that are looked at."""
_LASTS = ("wait", "get")
_BODIES = ("function_definition", "lambda_expression")
_PLAIN = regex(r"(?:this->)?(?P<client>[A-Za-z_]\w*)->async_\w+\Z")


def endless_answers(code: Code) -> Iterator[EndlessAnswer]:
    """The first wait of each function for the answer to a request of its own, unless something else of the function
    may end it."""
    told: set[int] = set()
    waits = islice((call for call in code.calls if call.name in _LASTS and not call.arguments), WAITS)
    for call in waits:
        body = _body(code, call.node)
        if body is None or body.id in told or code.function_name(call.node) in (None, "main"):
            continue
        asked = _asked(code, call, body)
        client = _PLAIN.match(asked.qualified) if asked is not None else None
        if asked is not None and client is not None:
            told.add(body.id)
            yield EndlessAnswer(code.span(call.node), code.span(asked.node), client["client"], asked.name)


def _body(code: Code, node: Node) -> Node | None:
    return next((each for each in code.above(node) if each.type in _BODIES), None)


def _asked(code: Code, call: Call, body: Node) -> Call | None:
    """The request whose answer a call waits for without end."""
    held = call.qualified.removesuffix(f".{call.name}").removesuffix(".future")
    for each in code.calls:
        if each.name not in ASKS or not body.start_byte <= each.node.start_byte < call.node.end_byte:
            continue
        if call.node.start_byte <= each.node.start_byte:
            return each
        if code.kept(each.node) == held and not _is_bounded(blanked(code.text(body)), held):
            return each
    return None


def _is_bounded(text: str, name: str) -> bool:
    """Whether a function waits for an answer in another way, too, or hands it to something that may."""
    word = re.escape(name)
    elsewhere = rf"\b{word}(?:\.future)?\s*(?:\.\s*(?:wait_for|wait_until|valid)\b|[,)])"
    return re.search(elsewhere, text) is not None
