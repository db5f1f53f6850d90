"""Patterns that are compiled when they are first asked. The modules of a run hold some hundred, and most are never
asked: to compile them all takes as long as the rest of a small run."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any
from typing import AnyStr
from typing import cast

_FEW = 16
"""Texts in which hints are looked for, before the pattern is compiled: that takes as long."""
_LOOKING = ("search", "match", "fullmatch")


class Uncompiled:
    """Stands for a pattern. What is asked of it once is kept, so that asking again costs nothing."""

    __slots__ = (
        "findall",
        "finditer",
        "flags",
        "fullmatch",
        "groupindex",
        "groups",
        "hints",
        "match",
        "pattern",
        "search",
        "split",
        "sub",
        "subn",
    )

    def __init__(self, pattern: str | bytes, flags: int, hints: str) -> None:
        self.pattern = pattern
        self.flags = flags
        self.hints = hints

    def __getattr__(self, name: str) -> Any:
        if self.hints and name in _LOOKING:
            value = self._with_hints(name)
        else:
            value = getattr(re.compile(self.pattern, self.flags), name)
        object.__setattr__(self, name, value)
        return value

    def _with_hints(self, name: str) -> Callable[..., Any]:
        """The method that compiles nothing for texts without a hint, as long as they are few."""
        hints = self.hints.split()
        left = _FEW

        def look(text: str, *bounds: int) -> Any:
            nonlocal left
            left -= 1
            if left >= 0 and text.isascii() and not has_one(text.lower() if self.flags & re.I else text, hints):
                return None
            compiled = getattr(re.compile(self.pattern, self.flags), name)
            object.__setattr__(self, name, compiled)
            return compiled(text, *bounds)

        return look


def has_one(text: str, words: list[str]) -> bool:
    """Whether one of some words is anywhere in a text."""
    return any(word in text for word in words)


def regex(pattern: AnyStr, flags: int = 0, hints: str = "") -> re.Pattern[AnyStr]:
    """A pattern for a module to hold. It has the methods of a compiled one; the functions of ``re`` do not take it.
    Each text that it matches holds one of the ``hints``, which are separated by blanks, and in lower case where case
    does not count."""
    return cast("re.Pattern[AnyStr]", Uncompiled(pattern, flags, hints))
