"""In which texts a word stands, for many questions: the first look at the texts, and the others at their words."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from bringup_lint.graph.memo import memo
from bringup_lint.pattern import regex

_FEW = 50
"""Questions for which to list all words takes longer."""
_WORD = regex(r"\w+")
_COMMENT = regex(r"#[^\n]*")
_CALL = regex(r"(?<!\w)\w{1,200}(?=[ \t]{0,20}\()")


class Words:
    """The words of texts, each with the name of its file."""

    def __init__(self, texts: Mapping[str, str]) -> None:
        self._texts = texts
        self._left = _FEW

    @memo
    def having(self, word: str) -> list[str]:
        """The files that have a word as a whole."""
        self._left -= 1
        if self._left < 0:
            return self._listed.get(word, [])
        return [name for name, text in self._texts.items() if word in text and _has(text, word)]

    @cached_property
    def _listed(self) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for name, text in self._texts.items():
            for word in set(_WORD.findall(text)):
                found.setdefault(word, []).append(name)
        return found

    @memo
    def put_away(self, name: str) -> frozenset[str]:
        """What the comments of a file call, and so put away."""
        text = self._texts[name]
        return frozenset(call for comment in _COMMENT.findall(text) for call in _CALL.findall(comment))


def _has(text: str, word: str) -> bool:
    """Whether a text has a word as a whole."""
    at = text.find(word)
    while at >= 0:
        before, after = text[at - 1 : at], text[at + len(word) : at + len(word) + 1]
        if not (before.isidentifier() or before.isdigit() or after == "_" or after.isalnum()):
            return True
        at = text.find(word, at + 1)
    return False
