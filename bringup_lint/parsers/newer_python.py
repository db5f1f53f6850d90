"""Python of newer releases, written so that older ones read it: from 3.12 on, f-strings may hold the quotes that they
stand in, and backslashes (PEP 701). All places stay as they are."""

from __future__ import annotations

from bringup_lint.pattern import regex

HOLDS = regex(r"(?i)(?<![a-z0-9_])(?:f|fr|rf)[\"']")
_QUOTED = r"(?<![a-z0-9_])(?P<prefix>[bfru]{0,2})(?P<quote>\"\"\"|'''|\"|')"
_STRING = regex("(?i)" + _QUOTED)
_START = regex(r"(?i)#[^\n]*|" + _QUOTED)
_OTHER = {'"': "'", "'": '"'}
_MOST = 10
"""Levels of f-strings in each other."""
_OPENING, _CLOSING = frozenset("([{"), frozenset(")]}")


def as_older(text: str) -> str:
    """The text with other quotes, and without backslashes, in what f-strings fill in. Where that cannot be done, the
    text or a part of it stays."""
    writer, at = _Writer(text), 0
    while (found := _START.search(text, at)) is not None:
        at = found.end() if found["quote"] is None else writer.string(found["prefix"], found["quote"], found.end())
    return "".join(writer.letters)


class _Writer:
    def __init__(self, text: str) -> None:
        self._text = text
        self.letters = list(text)

    def string(self, prefix: str, quote: str, at: int, around: str = "", level: int = 0) -> int:
        """Where a string ends. ``around``: the quotes of the f-string that it is filled into."""
        is_filled, text = "f" in prefix.lower(), self._text
        begin = at - len(quote)
        while at < len(text) and not text.startswith(quote, at):
            if text[at] == "\\":
                if around:
                    self.letters[at] = "/"
                at += 2
            elif is_filled and text[at] == "{" and level < _MOST:
                at = at + 2 if text.startswith("{{", at) else self._filled(quote, at + 1, level + 1)
            elif text[at] == "\n" and len(quote) == 1:
                return at
            else:
                at += 1
        if quote == around and len(quote) == 1:
            self.letters[begin] = self.letters[min(at, len(text) - 1)] = _OTHER[quote]
        return at + len(quote)

    def _filled(self, quote: str, at: int, level: int) -> int:
        """Where an expression ends that an f-string fills in."""
        text, depth, is_format = self._text, 0, False
        while at < len(text):
            letter = text[at]
            if letter == "#" and not is_format:
                end = text.find("\n", at)
                at = len(text) if end < 0 else end
                continue
            start = _STRING.match(text, at) if depth or not is_format else None
            if start is not None:
                at = self.string(start["prefix"], start["quote"], start.end(), quote, level)
                continue
            if letter == "}" and not depth:
                return at + 1
            if letter == "\n" and len(quote) == 1:
                return at
            depth += (letter in _OPENING) - (letter in _CLOSING)
            is_format = is_format or (letter == ":" and not depth)
            at += 1
        return at
