"""Waits in the callbacks of a C++ file for what only another callback of the same executor can do."""

from __future__ import annotations

import re
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.model.node_source import Callback
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

LEAVES = frozenset({"break_statement", "return_statement", "throw_statement", "co_return_statement", "goto_statement"})
_ASKING = regex(r"async_(?:send_request|send_goal|get_result|cancel_goal)\b")
_CLIENT = regex(r"(?P<client>[\w.>-]{1,80}?)(?:->|\.)async_\w+\s{0,4}\(")
_TIMED = regex(r"\b(?:wait_for|wait_until|spin_until_future_complete)\s{0,4}\(")
"""Waits that end, or that run an executor of their own, after which ``get`` returns at once."""
_MEMBER = regex(r"[A-Za-z]\w*_\Z|m_\w+\Z")
_CONDITION = regex(r"[\s!&|()=\w.>:-]+\Z")
_WORD = regex(r"[A-Za-z_]\w*")
_KNOWN = frozenset({"this", "true", "false", "load", "rclcpp", "ok", "nullptr", "not", "and", "or"})
_CHANGES = r"\s{0,4}(?:=(?!=)|\+\+|--|[+|&-]=|(?:\.|->)\s{0,4}(?!load\b)\w+\s{0,4}\()"
_GROUP = {"create_service": 3, "create_client": 2, "create_wall_timer": 2}
"""Calls, and which of their arguments is the callback group."""


class Partners:
    """Who ends the waits of one file."""

    def __init__(self, code: Code, bodies: dict[int, Node]) -> None:
        """``bodies``: the definitions of the callbacks, by where these are handed over."""
        self._code = code
        self._bodies = bodies

    def loop(self, loop: Node, callback: Callback) -> str | None:
        """The condition of a loop that only other callbacks can end; None for any other loop."""
        condition = self._code.text(loop.child_by_field_name("condition"))
        body = loop.child_by_field_name("body")
        if body is None or "std::thread" in self._code.source.text or not _CONDITION.match(condition):
            return None
        words = [word for word in _WORD.findall(condition) if word not in _KNOWN]
        if len(set(words)) != 1 or not _MEMBER.match(words[0]) or self._leaves(body):
            return None
        text = self._code.text(body)
        if "spin" in text or re.search(rf"\b{re.escape(words[0])}\b", text) or re.search(r"\bthis\s*[,)]", text):
            return None
        return f"while {' '.join(condition.split())}" if self._is_set_by_others(words[0], callback) else None

    def _leaves(self, body: Node) -> bool:
        stack = [body]
        while stack:
            current = stack.pop()
            if current.type in LEAVES:
                return True
            stack += current.named_children
        return False

    def _is_set_by_others(self, name: str, callback: Callback) -> bool:
        """Whether callbacks alone change a member, and not only this one."""
        places = [found.start() for found in re.finditer(rf"\b{re.escape(name)}{_CHANGES}", self._code.source.text)]
        others = False
        for place in places:
            holder = self._holder(place)
            if holder is None and not self._is_at_start(place):
                return False
            others |= holder is not None and holder != callback.span.start
        return others

    def _holder(self, place: int) -> int | None:
        """The callback whose own definition a place is in."""
        found = [
            (self._code.span(body).end - self._code.span(body).start, start)
            for start, body in self._bodies.items()
            if self._code.span(body).start <= place < self._code.span(body).end
        ]
        return min(found)[1] if found else None

    def _is_at_start(self, place: int) -> bool:
        """Whether a place is in a constructor, or in no function at all."""
        for function in self._functions:
            span = self._code.span(function)
            if span.start <= place < span.end:
                return function.child_by_field_name("type") is None
        return True

    @cached_property
    def _functions(self) -> list[Node]:
        return self._code.written.get("function", [])

    def answer(self, call: Call, function: Node, callback: Callback) -> str | None:
        """``future.get()`` for the answer to a client of the group that the callback blocks; None for any other."""
        text = self._code.text(call.node.child_by_field_name("function"))
        asked = "".join(text.split()).removesuffix(call.name).rstrip(".->").removesuffix(".future")
        if call.arguments or not asked:
            return None
        value = asked
        if not _ASKING.search(asked):
            if _TIMED.search(self._code.text(function)):
                return None
            value = self._value(function, asked) or ""
        found = _CLIENT.match(value) if _ASKING.search(value) else None
        if found is None:
            return None
        client = found["client"].removeprefix("this->")
        if self._group_of_client(client) != self._group_of(callback):
            return None
        return f"{asked}.{call.name}()" if value is not asked else f"{call.name}() of the answer to {client}"

    def _value(self, function: Node, variable: str) -> str | None:
        """What a variable of a function is made with."""
        for made in self._code.written.get("made", ()):
            if function.start_byte < made.start_byte < function.end_byte:
                if self._code.text(made.child_by_field_name("declarator")).lstrip("*& ") == variable:
                    return "".join(self._code.text(made.child_by_field_name("value")).split())
        return None

    def _group_of_client(self, client: str) -> str | None:
        """The group with which a client is made: empty for the default one, None when that is not known."""
        made = [
            call for call in self._code.calls if call.name == "create_client" and self._code.kept(call.node) == client
        ]
        return self._group(made[0]) if len(made) == 1 else None

    def _group_of(self, callback: Callback) -> str:
        """As ``_group_of_client``; a group that is not known is called by a name that no other has."""
        for call in self._code.calls:
            if call.name.startswith("create_") and callback.span.start in self._starts(call):
                found = self._group(call)
                return found if found is not None else "?"
        return "?"

    def _starts(self, call: Call) -> set[int]:
        return {self._code.span(each).start for each in call.arguments}

    def _group(self, call: Call) -> str | None:
        if call.name == "create_subscription":
            return self._of_options(call)
        if call.name not in _GROUP or call.qualified.startswith("rclcpp_action"):
            return "" if call.name == "create_client" and len(call.arguments) == 2 else None
        given = call.arguments[_GROUP[call.name] :]
        group = self._code.text(given[0]) if given else ""
        return None if group and self._is_reentrant(group) else group

    def _of_options(self, call: Call) -> str | None:
        if len(call.arguments) < 4:
            return ""
        options = re.escape(self._code.text(call.arguments[3]))
        found = re.search(
            rf"\b{options}\s{{0,4}}\.\s{{0,4}}callback_group\s{{0,4}}=\s{{0,4}}(\w+)", self._code.source.text
        )
        return found[1] if found is not None and not self._is_reentrant(found[1]) else None

    def _is_reentrant(self, group: str) -> bool:
        made = re.search(rf"\b{re.escape(group)}\s{{0,4}}=[^;]{{0,200}}MutuallyExclusive", self._code.source.text)
        return made is None
