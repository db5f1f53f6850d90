"""How much C++ the parsers read."""

from __future__ import annotations

from bringup_lint.pattern import regex
from bringup_lint.source import Problem
from bringup_lint.source import Source

TEXT = 400_000
"""Code points of a source."""
NESTED = 1_000
"""Brackets that are open at one place, comments and texts included: with more, recovery from errors takes too long."""
_BRACKET = regex(r"[()\[\]{}]")


def too_much(source: Source) -> Problem | None:
    """``too-large`` or ``too-deep``; None when the source can be read."""
    if len(source.text) > TEXT:
        return Problem("too-large", source.whole)
    return Problem("too-deep", source.whole) if _open_brackets(source.text) > NESTED else None


def _open_brackets(text: str) -> int:
    """The most brackets that are open at one place, of whatever kind."""
    most = level = 0
    for found in _BRACKET.finditer(text):
        level = level + 1 if found[0] in "([{" else max(0, level - 1)
        most = max(most, level)
    return most
