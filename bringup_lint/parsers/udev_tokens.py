"""One logical udev rule line to its tokens, after ``parse_line`` of systemd's udev-rules.c."""

from __future__ import annotations

import re

from bringup_lint.model.udev import Token
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.udev_lines import BLANKS
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem

_DELIMITERS = regex(r"[ \t\n\r,]*")
_KEY = regex(r"(?:(?![-+!:]=)[^ \t\n\r={])*")
_OPERATOR = regex(r"[ \t\n\r]*(==|!=|\+=|-=|:=|=)[ \t\n\r]*")
_VALUE = regex(r"([ei]{0,2})\"")
_PLAIN_END = regex(r"(?:[^\"\\]|\\\"|\\(?!\"))*")
_ESCAPED_END = regex(r"(?:[^\"\\]|\\.)*", re.DOTALL)
_USUAL = regex(
    r"(?P<key>[A-Z_]+)(?:\{(?P<attribute>[^}\"]{0,200})\})?[ \t\n\r]*(?P<operator>==|!=|\+=|-=|:=|=)[ \t\n\r]*"
    r"\"(?P<value>[^\"\\]*)\""
)
"""A token with nothing in its value that means something else than it says."""
_RESUME = regex(r"[ \t,](?=[A-Za-z]+(?:\{[^}\"]*\})?[ \t]*(?:==|!=|\+=|-=|:=|=))")
_SINGLE_QUOTED = regex(r"'([^'\"]*)'(?=[ \t\r\n,]|\Z)")
_ESCAPE = regex(r"\\(x[0-9A-Fa-f]{2}|u[0-9A-Fa-f]{4}|U[0-9A-Fa-f]{8}|[0-7]{3}|[abfnrtv\\\"'s])|\\")
_QUOTE = regex(r"\\\"")
_SIMPLE = dict(zip("abfnrtvs\\\"'", "\a\b\f\n\r\t\v \\\"'", strict=True))


class Reading(NamedTuple):
    tokens: list[Token]
    problem: Problem | None
    """The first thing that no token could be made of: udev drops the whole line for it."""


class _Unreadable(Exception):
    def __init__(self, problem: Problem):
        self.problem = problem


def read_tokens(line: Located) -> Reading:
    """All tokens of a line, with those after an unreadable place as far as they can be found again."""
    tokens: list[Token] = []
    problem: Problem | None = None
    at = _skip(_DELIMITERS, line, 0)
    while at < len(line):
        try:
            token, at = _read_token(line, at)
            tokens.append(token)
        except _Unreadable as unreadable:
            problem = problem or unreadable.problem
            resumed = _RESUME.search(line, at + 1)
            if resumed is None:
                break
            at = resumed.end()
        at = _skip(_DELIMITERS, line, at)
    return Reading(tokens, problem)


def _skip(pattern: re.Pattern[str], line: str, at: int) -> int:
    found = pattern.match(line, at)
    return found.end() if found else at


def _read_token(line: Located, start: int) -> tuple[Token, int]:
    usual = _USUAL.match(line, start)
    if usual is None:
        return _read_unusual(line, start)
    key, operator, value = (line.part(*usual.span(group)) for group in ("key", "operator", "value"))
    attribute = None if usual["attribute"] is None else line.part(*usual.span("attribute"))
    return Token(key, attribute, operator, value, line.part(start, usual.end()).span), usual.end()


def _read_unusual(line: Located, start: int) -> tuple[Token, int]:
    key_end = _skip(_KEY, line, start)
    key = line.part(start, key_end)
    attribute = None
    at = key_end
    if line.startswith("{", at):
        close = line.find("}", at)
        if close == -1:
            raise _Unreadable(Problem("attribute-not-closed", line.part(start, len(line)), key))
        attribute = line.part(at + 1, close)
        at = close + 1
    operator = _OPERATOR.match(line, at)
    if operator is None:
        raise _Unreadable(_no_operator(line, start, max(at, start + 1)))
    prefix, value, end = _read_value(line, operator.end())
    return Token(key, attribute, line.part(*operator.span(1)), value, line.part(start, end).span, prefix), end


def _no_operator(line: Located, start: int, end: int) -> Problem:
    if line.startswith("\\", start) and not line[start + 1 :].strip(BLANKS):
        return Problem("blank-after-backslash", line.part(start, len(line)))
    return Problem("no-operator", line.part(start, end))


def _read_value(line: Located, at: int) -> tuple[str, Located, int]:
    opening = _VALUE.match(line, at)
    if opening is None or opening[1] in ("ee", "ii"):
        raise _Unreadable(_no_value(line, at))
    escaped = "e" in opening[1]
    start = opening.end()
    end = _skip(_ESCAPED_END if escaped else _PLAIN_END, line, start)
    if not line.startswith('"', end):
        raise _Unreadable(Problem("value-not-closed", line.part(at, len(line))))
    return opening[1], _unescaped(line.part(start, end), escaped), end + 1


def _no_value(line: Located, at: int) -> Problem:
    quoted = _SINGLE_QUOTED.match(line, at)
    if quoted is not None:
        return Problem("single-quoted-value", line.part(*quoted.span()))
    end = at
    while end < len(line) and line[end] not in BLANKS + ",":
        end += 1
    return Problem("unquoted-value", line.part(at, max(end, min(at + 1, len(line)))))


def _unescaped(value: Located, escaped: bool) -> Located:
    if "\\" not in value:
        return value
    pattern = _ESCAPE if escaped else _QUOTE
    texts: list[str] = []
    pieces: list[tuple[int, int]] = []
    at = length = 0
    for found in pattern.finditer(value):
        character = _meaning(found[1]) if escaped else '"'
        if not character:
            raise _Unreadable(Problem("bad-escape", value.part(found.start(), min(found.end() + 1, len(value)))))
        if found.start() > at:
            pieces.append((length, value.origin(at)))
            texts.append(value[at : found.start()])
            length += found.start() - at
        pieces.append((length, value.origin(found.start())))
        texts.append(character)
        length += len(character)
        at = found.end()
    if at < len(value):
        pieces.append((length, value.origin(at)))
        texts.append(value[at:])
    return Located("".join(texts), value.span, tuple(pieces))


def _meaning(escape: str | None) -> str:
    """The character of a C escape; empty when udev refuses it."""
    if not escape:
        return ""
    if escape[0] in "xuU":
        number = int(escape[1:], 16)
    elif len(escape) == 3:
        number = int(escape, 8)
    else:
        return _SIMPLE[escape]
    if number == 0 or number > 0x10FFFF or (len(escape) == 3 and number > 0xFF):
        return ""
    return chr(number)
