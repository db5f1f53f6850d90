"""Shell patterns of udev values (fnmatch(3) without flags): what they match, and what two can both match."""

from __future__ import annotations

import re
from functools import lru_cache

from bringup_lint.pattern import regex

_LONGEST = 256
_SPECIAL = regex(r"[*?\[\\]")


def is_plain(pattern: str) -> bool:
    """Whether the pattern matches one text only."""
    return not _SPECIAL.search(pattern)


def matches(pattern: str, text: str) -> bool:
    """Whether the pattern matches the whole text; a pattern too long to judge matches nothing but itself."""
    if len(pattern) > _LONGEST or is_plain(pattern):
        return pattern == text
    return _compiled(pattern).match(text) is not None


def may_overlap(one: str, other: str) -> bool:
    """Whether some text is matched by both patterns; True when that would take too long to find out."""
    if is_plain(one) and is_plain(other):
        return one == other
    if len(one) > _LONGEST or len(other) > _LONGEST:
        return True
    if is_plain(one):
        return matches(other, one)
    if is_plain(other):
        return matches(one, other)
    return _overlap(_pieces(one), _pieces(other))


@lru_cache(maxsize=1024)
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile("".join(_as_regex(piece) for piece in _pieces(pattern)) + r"\Z", re.DOTALL)


def _overlap(one: list[str], other: list[str]) -> bool:
    """Walks both patterns at once; a star may swallow whatever the other pattern has next."""
    reached = {(0, 0)}
    pending = [(0, 0)]
    while pending:
        i, j = pending.pop()
        if i == len(one) and j == len(other):
            return True
        for step in _steps(one, i, other, j):
            if step not in reached and step[0] <= len(one) and step[1] <= len(other):
                reached.add(step)
                pending.append(step)
    return False


def _steps(one: list[str], i: int, other: list[str], j: int) -> list[tuple[int, int]]:
    left = one[i] if i < len(one) else ""
    right = other[j] if j < len(other) else ""
    if "*" in (left, right):
        return [(i + 1, j), (i, j + 1)]
    return [(i + 1, j + 1)] if left and right and _same(left, right) else []


def _same(one: str, other: str) -> bool:
    """Whether two single-character pieces can be one character; two classes are taken to overlap."""
    if one == "?" or other == "?" or one[0] == other[0] == "[":
        return True
    if one[0] == "[" or other[0] == "[":
        kind, piece = (one, other) if one[0] == "[" else (other, one)
        return re.match(_as_regex(kind), piece[-1]) is not None
    return one[-1] == other[-1]


def _pieces(pattern: str) -> list[str]:
    """``*``, ``?``, a whole ``[...]`` class, a character, or a backslash with its character."""
    pieces: list[str] = []
    at = 0
    while at < len(pattern):
        end = at + 1
        piece = pattern[at]
        if piece == "\\" and end < len(pattern):
            end += 1
        elif piece == "[":
            close = pattern.find("]", at + (3 if pattern[end : end + 1] in ("!", "^") else 2))
            end = close + 1 if close != -1 else end
        pieces.append(pattern[at:end] if pattern[at:end] != "[" else "\\[")
        at = end
    return pieces


def _as_regex(piece: str) -> str:
    if piece == "*":
        return ".*"
    if piece == "?":
        return "."
    return _class(piece[1:-1]) if piece[0] == "[" else re.escape(piece[-1])


def _class(inner: str) -> str:
    negated = inner[0] in "!^"
    members = inner[1:] if negated else inner
    text = "".join(character if character == "-" else re.escape(character) for character in members)
    regex = f"[^{text}]" if negated else f"[{text}]"
    try:
        re.compile(regex)
    except re.error:
        return "."
    return "." if "[:" in inner else regex
