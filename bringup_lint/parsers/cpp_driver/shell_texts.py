"""Shell commands of a C++ file that hold text of a message, a request or a goal, unquoted and unchecked."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import ShellText
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.parsers.cpp_node.syntax import FUNCTIONS
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

MOST = 50
"""Calls and statements that are looked at."""
RUNS = regex(r"\b(?:system|popen)\s{0,4}\(", hints="system popen")
BRINGS = regex(r"::Request\b|\bmsg::String\b|\bget_goal\b", hints="::Request msg::String get_goal")
_SHELLS = ("system", "std::system", "::system", "popen", "::popen")
_GIVEN = regex(
    r"(?:::Request|\bmsg::String)\b(?:::\w{0,40}Ptr)?\s{0,4}>?\s{0,4}(?:const\s{0,4})?&{0,2}\s{0,4}"
    r"(?P<name>[A-Za-z_]\w{0,80})\s{0,4}[,)]"
)
"""A parameter that is a request or a text message."""
_GOAL = regex(r"\b(?P<name>[A-Za-z_]\w{0,80})\s{0,4}=\s{0,4}[\w.>-]{1,80}\bget_goal\s{0,4}\(")
_STATEMENT = regex(
    r"(?:(?:\b(?P<type>string|auto)\b[\s&]{1,6}(?P<made>[A-Za-z_]\w{0,80})\s{0,4}[=({]"
    r"|(?<![\w.>])(?P<name>[A-Za-z_]\w{0,80})\s{0,4}(?:\+?=(?!=)|<<))"
    r"|\bsn?printf\s{0,4}\(\s{0,4}(?P<buffer>[A-Za-z_]\w{0,80})[\s.\w()]{0,20},)(?P<value>[^;{]{1,600});"
)
"""What gives a variable, a stream or a buffer a value."""
_CHECKS = regex(
    r"(?i)\bregex|\.\s{0,4}(?:find|count|contains|starts_with|at)\w{0,20}\s{0,4}\(|\bisal|\b(?:all|any|none)_of\b"
    r"|quote|escape|sanit|valid|allow|==\s{0,4}\"[^\"]"
)
"""What looks at a text before it is used, or quotes it."""
_WORD = regex(r"[A-Za-z_]\w*")
_NUMBER = regex(r"\b(?:to_string|static_cast<\w+>)\s{0,4}\(\s{0,4}\Z")
_FIELD = (
    r"(?<![\w.>])(?:{0})\s{{0,4}}(?:->|\.)\s{{0,4}}[a-z]\w{{0,60}}(?:\.data\b)?"
    r"(?!\w|\s{{0,4}}\.\s{{0,4}}(?:size|length|empty)\b)"
)
_JOINED = r"{0}\s{{0,4}}\.\s{{0,4}}c_str\b|\"\s{{0,4}}\+\s{{0,4}}{0}|{0}\s{{0,4}}\+\s{{0,4}}\""
"""What only texts are in, and no numbers."""


def shell_texts(code: Code) -> Iterator[ShellText]:
    plain = plain_of(code.source)
    calls = (each for each in code.calls if each.qualified in _SHELLS and each.arguments)
    for call in islice(calls, MOST):
        given = code.span(call.arguments[0])
        for function in (each for each in code.above(call.node) if each.type in FUNCTIONS):
            start = code.span(function).start
            brought = _brought(code, plain, function)
            if brought and not _CHECKS.search(plain, start, given.start):
                place = _Texts(plain, start, given.start, brought).within(given.start, given.end)
                if place is not None:
                    yield ShellText(code.span(call.node), code.source.span(*place))
                break


def _brought(code: Code, plain: str, function: Node) -> list[str]:
    """The names of the requests, messages and goals of a function."""
    span, body = code.span(function), function.child_by_field_name("body")
    head = code.span(body).start if body is not None else span.end
    given = [each["name"] for each in _GIVEN.finditer(plain, span.start, head)]
    return given + [each["name"] for each in _GOAL.finditer(plain, head, span.end)]


class _Texts:
    """Where what a function was sent is read, by the names that hold text of it up to a place."""

    def __init__(self, plain: str, start: int, end: int, brought: list[str]) -> None:
        field = _FIELD.format("|".join(map(re.escape, brought)))
        self._plain, self._end = plain, end
        self._field, self._joined = re.compile(field), re.compile(_JOINED.format(f"(?:{field})"))
        self._held: dict[str, tuple[int, int]] = {}
        for each in islice(_STATEMENT.finditer(plain, start, end), MOST):
            name = each["made"] or each["name"] or each["buffer"]
            is_text = each["type"] == "string" or (each["type"] == "auto" and self._is_joined(name, each.end()))
            place = self.within(*each.span("value"), is_text=is_text)
            if place is not None:
                self._held.setdefault(name, place)

    def within(self, start: int, end: int, *, is_text: bool = False) -> tuple[int, int] | None:
        """Where the text was read that an expression holds."""
        found = next((each[0] for each in _WORD.finditer(self._plain, start, end) if each[0] in self._held), None)
        if found is not None:
            return self._held[found]
        field = (self._field if is_text else self._joined).search(self._plain, start, end)
        if field is None or _NUMBER.search(self._plain, start, field.start()):
            return None
        read = self._field.search(self._plain, *field.span())
        return read.span() if read is not None else None

    def _is_joined(self, name: str, start: int) -> bool:
        return re.compile(_JOINED.format(rf"\b{re.escape(name)}\b")).search(self._plain, start, self._end) is not None
