"""Answers of services and actions that a C++ file waits for without a timeout."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import EndlessAnswer
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

ASKS = ("async_send_request", "async_send_goal")
"""What may be sent before there was a server; a goal is canceled only after its server has answered."""
_LASTS = ("wait", "get")
_PLAIN = regex(r"(?:this->)?(?P<client>[A-Za-z_]\w*)->async_\w+\Z")


def endless_answers(code: Code) -> Iterator[EndlessAnswer]:
    """The first wait of each function for the answer to a request of its own, unless something else of the function
    may end it."""
    requests = _Requests(code)
    told: set[int] = set()
    for call in code.calls:
        body = code.body_of(call.node) if call.name in _LASTS and not call.arguments else None
        if body is None or body.id in told:
            continue
        asked = requests.answered(call, body)
        client = _PLAIN.match(asked.qualified) if asked is not None else None
        if asked is not None and client is not None and code.function_name(call.node) not in (None, "main"):
            told.add(body.id)
            yield EndlessAnswer(code.span(call.node), code.span(asked.node), client["client"], asked.name)


class _Requests:
    """The requests of a file, by themselves and by the function and variable that hold their futures."""

    def __init__(self, code: Code) -> None:
        requests = [each for each in code.calls if each.name in ASKS]
        self._by_node = {each.node.id: each for each in requests}
        self._kept: dict[tuple[int, str], Call] = {}
        for each in requests:
            body, name = code.body_of(each.node), code.kept(each.node)
            if body is not None and name is not None and not _is_bounded(blanked(code.text(body)), name):
                self._kept.setdefault((body.id, name), each)

    def answered(self, call: Call, body: Node) -> Call | None:
        """The request whose answer a call waits for without end."""
        held = call.qualified.removesuffix(f".{call.name}").removesuffix(".future")
        found = self._kept.get((body.id, held))
        if found is not None:
            return found if found.node.start_byte < call.node.start_byte else None
        inner = call.node.child_by_field_name("function")
        while inner is not None and inner.type == "field_expression":
            inner = inner.child_by_field_name("argument")
        return self._by_node.get(inner.id) if inner is not None else None


def _is_bounded(text: str, name: str) -> bool:
    """Whether a function waits for an answer in another way, too, or hands it to something that may."""
    word = re.escape(name)
    elsewhere = rf"\b{word}(?:\.future)?\s*(?:\.\s*(?:wait_for|wait_until|valid)\b|[,)])"
    return re.search(elsewhere, text) is not None
