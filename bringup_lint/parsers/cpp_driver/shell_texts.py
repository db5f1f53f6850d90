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
"""Calls, statements and uses that are looked at."""
_FARTHEST = 600
"""Letters in which a statement begins."""
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
_LITERAL = regex(r"'(?:[^'\\\n]|\\.){1,4}'|\"(?:[^\"\\\n]|\\.)*\"")
_WORD = regex(r"(?<![\w.>:])[A-Za-z_]\w*(?!\s{0,4}\.\s{0,4}(?:size|length|empty)\b)")
_BEFORE = regex(r"(?P<name>\w{1,60})(?:\s{0,4}<[^<>;]{0,60}>)?\s{0,4}\Z")
_KEEPS = regex(
    r"(?:RCLCPP_\w+|ROS_\w+|[sf]?n?printf|print|info|warn|error|debug|system|popen|string|str|c_str|append|return|sizeof)\Z"
)
"""Calls that log a text, run it or hand it on as it is."""
_CONDITION = regex(r"(?:if|while)\Z")
_IS_NOT_EMPTY = regex(r"\s{0,4}(?:!=\s{0,4}\"\"|\.\s{0,4}(?:size|length|empty)\b)")
_FIELD = (
    r"(?<![\w.>])(?:{0})\s{{0,4}}(?:->|\.)\s{{0,4}}[a-z]\w{{0,60}}(?:\.data\b)?"
    r"(?!\w|\s{{0,4}}\.\s{{0,4}}(?:size|length|empty)\b)"
)
_JOINED = r"{0}\s{{0,4}}\.\s{{0,4}}c_str\b|\"\s{{0,4}}\+\s{{0,4}}{0}|{0}\s{{0,4}}\+\s{{0,4}}\""
"""What only texts are in, and no numbers."""
_WHOLE = r"\s{{0,40}}{0}\s{{0,4}}\)?\s{{0,4}}\Z"
"""The value of a text that is nothing else."""

Place = tuple[int, int]


def shell_texts(code: Code) -> Iterator[ShellText]:
    plain = plain_of(code.source)
    bare = _LITERAL.sub(lambda each: each[0][0] + " " * (len(each[0]) - 2) + each[0][0], plain)
    calls = (each for each in code.calls if each.qualified in _SHELLS and each.arguments)
    functions: dict[int, _Texts | None] = {}
    for call in islice(calls, MOST):
        function = next((each for each in code.above(call.node) if each.type in FUNCTIONS), None)
        if function is None:
            continue
        if function.id not in functions:
            functions[function.id] = _texts(code, plain, bare, function)
        texts, given = functions[function.id], code.span(call.arguments[0])
        place = texts.taken(given.start, given.end) if texts is not None else None
        if place is not None:
            yield ShellText(code.span(call.node), code.source.span(*place))


def _texts(code: Code, plain: str, bare: str, function: Node) -> _Texts | None:
    """What a function knows of the requests, messages and goals that it is sent, up to where it looks into a text."""
    span, body = code.span(function), function.child_by_field_name("body")
    head = code.span(body).start if body is not None else span.end
    given = [each["name"] for each in _GIVEN.finditer(plain, span.start, head)]
    brought = given + [each["name"] for each in _GOAL.finditer(plain, head, span.end)]
    if not brought:
        return None
    check = _CHECKS.search(plain, span.start, span.end)
    return _Texts(bare, head, check.start() if check is not None else span.end, brought)


class _Texts:
    """Where what a function was sent is read, by the names that hold text of it. ``plain`` has blanks for literals."""

    def __init__(self, plain: str, start: int, end: int, brought: list[str]) -> None:
        field = _FIELD.format("|".join(map(re.escape, brought)))
        self._plain, self._start, self._end = plain, start, end
        self._field, self._joined = re.compile(field), re.compile(_JOINED.format(f"(?:{field})"))
        self._whole = re.compile(_WHOLE.format(f"(?:{field})"))
        self._held: dict[str, tuple[int, Place]] = {}
        for each in islice(_STATEMENT.finditer(plain, start, end), MOST):
            name = each["made"] or each["name"] or each["buffer"]
            is_text = each["type"] == "string" or (each["type"] == "auto" and self._is_joined(name, each.end()))
            place = self._read(*each.span("value"), is_text=is_text)
            if place is not None:
                self._held.setdefault(name, (each.start(), place))

    def taken(self, start: int, end: int) -> Place | None:
        """Where the text was read that the argument of a call holds, when nothing before looks at it."""
        place = self._read(start, end) if end <= self._end else None
        return place if place is not None and not self._is_looked_at(place, start) else None

    def _read(self, start: int, end: int, *, is_text: bool = False) -> Place | None:
        """Where the text was read that an expression holds."""
        for word in _WORD.finditer(self._plain, start, end):
            since, place = self._held.get(word[0], (end, None))
            if since < start and self._is_itself(start, word, end):
                return place
        whole = self._whole.match(self._plain, start, end) if is_text else None
        for found in [whole] if whole is not None else self._joined.finditer(self._plain, start, end):
            read = self._field.search(self._plain, *found.span())
            if read is not None and self._is_itself(start, read, end):
                return read.span()
        return None

    def _is_itself(self, start: int, read: re.Match[str], end: int) -> bool:
        """Whether what is read there becomes part of a value: it chooses none, and no other function makes one of
        it."""
        if read.start() - start > _FARTHEST or "?" in self._plain[read.end() : end]:
            return False
        return all(_KEEPS.match(each) for each in self._around(start, read.start()))

    def _around(self, start: int, at: int) -> Iterator[str]:
        """The words before the brackets that are open at a place; the bracket itself for an index."""
        level, first = 0, max(start, at - _FARTHEST)
        for i in range(at - 1, first - 1, -1):
            level += (self._plain[i] in ")]}") - (self._plain[i] in "([{")
            if level < 0:
                level = 0
                name = _BEFORE.search(self._plain, max(first, i - 2 * 60), i)
                if self._plain[i] == "[":
                    yield "["
                elif name is not None:
                    yield name["name"]

    def _is_looked_at(self, place: Place, end: int) -> bool:
        """Whether a condition or another function is given a text, under any of its names, before a place."""
        text = self._plain[slice(*place)]
        names = {name for name, (_, read) in self._held.items() if self._plain[slice(*read)] == text}
        reads = re.compile(rf"(?<![\w.>:])(?:{'|'.join(map(re.escape, sorted({text, *names})))})\b")
        uses = list(islice(reads.finditer(self._plain, self._start, end), MOST))
        return len(uses) == MOST or any(self._looks(each, names) for each in uses)

    def _looks(self, use: re.Match[str], names: set[str]) -> bool:
        first = max(self._start, use.start() - _FARTHEST)
        start = max(self._plain.rfind(each, first, use.start()) for each in ";{}") + 1
        for name in self._around(max(start, first), use.start()):
            if _CONDITION.match(name) and _IS_NOT_EMPTY.match(self._plain, use.end()):
                continue
            if name not in names and not _KEEPS.match(name):
                return True
        return False

    def _is_joined(self, name: str, start: int) -> bool:
        return re.compile(_JOINED.format(rf"\b{re.escape(name)}\b")).search(self._plain, start, self._end) is not None
