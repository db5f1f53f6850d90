"""Patterns that are compiled when they are first asked. The modules of a run hold some hundred, and most are never
asked: to compile them all takes as long as the rest of a small run. A long text that lacks all the words of which each
match holds one is not searched at all: a word is found about fifty times as fast as a pattern of many ways."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterable

from bringup_lint.type_names import Any
from bringup_lint.type_names import AnyStr
from bringup_lint.type_names import cast

_FEW = 16
"""Texts in which hints are looked for, before the pattern is compiled: that takes as long."""
_LONG = 60
"""Characters of a text for which to look for the hints pays even when the pattern is compiled."""
_LOOKING: dict[str, Callable[[], Any]] = {
    "search": lambda: None,
    "match": lambda: None,
    "fullmatch": lambda: None,
    "finditer": lambda: iter(()),
    "findall": list,
}
"""What looks at a text -> its answer where nothing matches."""
_AT_ONE_PLACE = ("match", "fullmatch")
_FOLDED = "\u0130\u0131\u017f\u212a"
"""The letters beyond ASCII that match i, s and k where case does not count."""


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
        """The method that compiles nothing for texts without a hint as long as they are few, and searches no long
        one."""
        none, searches = _LOOKING[name], name not in _AT_ONE_PLACE
        hints, folds = self.hints.split(), bool(self.flags & re.I)
        left = _FEW
        compiled: Callable[..., Any] | None = None

        def look(text: str, *bounds: int) -> Any:
            nonlocal left, compiled
            left -= 1
            pays = (left >= 0 and compiled is None) or (searches and len(text) > _LONG)
            if pays and _lacks(text, hints, folds):
                return none()
            if compiled is None:
                compiled = getattr(re.compile(self.pattern, self.flags), name)
                if not searches:
                    object.__setattr__(self, name, compiled)
            return compiled(text, *bounds)

        return look


def _lacks(text: str, hints: list[str], folds: bool) -> bool:
    """Whether a text holds no hint."""
    if not folds:
        return not has_one(text, hints)
    return (text.isascii() or not has_one(text, _FOLDED)) and not has_one(text.lower(), hints)


def has_one(text: str, words: Iterable[str]) -> bool:
    """Whether one of some words is anywhere in a text."""
    return any(word in text for word in words)


def regex(pattern: AnyStr, flags: int = 0, hints: str = "") -> re.Pattern[AnyStr]:
    """A pattern for a module to hold. It has the methods of a compiled one; the functions of ``re`` do not take it.
    Each text that it matches holds one of the ``hints``, which are separated by blanks, and in lower case where case
    does not count."""
    return cast("re.Pattern[AnyStr]", Uncompiled(pattern, flags, hints))
