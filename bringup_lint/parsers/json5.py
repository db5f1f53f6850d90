"""Whether a text is JSON5 (json5.org, 1.0): comments, bare keys, both quotes, trailing commas. Linear, no recursion."""

from __future__ import annotations

import re

from bringup_lint.parsers.matching import end_of
from bringup_lint.pattern import regex
from bringup_lint.source import Problem
from bringup_lint.source import Source

_BLANK = regex(r"(?:[\s\ufeff]+|//[^\n\r\u2028\u2029]*|/\*.*?\*/)*", re.S)
_STRING = r'"(?:[^"\\\n\r]|\\(?:\r\n|.))*"|\'(?:[^\'\\\n\r]|\\(?:\r\n|.))*\''
_NUMBER = r"[+-]?(?:0[xX][0-9a-fA-F]+|(?:(?:0|[1-9]\d*)(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?|Infinity|NaN)(?![\w$.])"
_SCALAR = regex(rf"{_STRING}|{_NUMBER}|(?:true|false|null)(?![\w$])", re.S)
_KEY = regex(rf"{_STRING}|(?:[^\W\d]|[$])[\w$\u200c\u200d]*", re.S)
_CLOSING = {"{": "}", "[": "]"}


def fault(source: Source) -> Problem | None:
    """The first place at which the text stops being JSON5; None when it is."""
    text = source.text
    open_brackets: list[int] = []
    at, state = 0, "value"
    while True:
        at = end_of(_BLANK, text, at)
        char = text[at : at + 1]
        bracket = text[open_brackets[-1]] if open_brackets else ""
        if char and state != "value" and char == _CLOSING.get(bracket):
            open_brackets.pop()
            at, state = at + 1, "behind"
        elif state == "behind" and not bracket:
            return _problem(source, at, "something follows the value") if char else None
        elif state == "behind":
            if char != ",":
                line = source.position(open_brackets[-1]).line
                return _problem(source, at, f"'{bracket}' of line {line} wants ',' or '{_CLOSING[bracket]}'")
            at, state = at + 1, "key" if bracket == "{" else "item"
        elif state == "key":
            key = _KEY.match(text, at)
            colon = end_of(_BLANK, text, key.end()) if key else at
            if key is None or text[colon : colon + 1] != ":":
                return _problem(source, colon, "':' is expected" if key else "a key is expected")
            at, state = colon + 1, "value"
        elif char in _CLOSING:
            open_brackets.append(at)
            at, state = at + 1, "key" if char == "{" else "item"
        else:
            scalar = _SCALAR.match(text, at)
            if scalar is None:
                return _problem(source, at, "a value is expected")
            at, state = scalar.end(), "behind"


def _problem(source: Source, at: int, detail: str) -> Problem:
    at = min(at, max(len(source.text) - 1, 0))
    return Problem("json5", source.span(at, min(at + 1, len(source.text))), detail)
