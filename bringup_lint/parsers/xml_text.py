"""XML character data: references decoded with their places kept, characters that XML forbids."""

from __future__ import annotations

import re
from collections.abc import Callable

from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

Report = Callable[[str, int, int, str], None]
"""Takes a problem: code, start and end offset, detail."""

PREDEFINED = {"lt": "<", "gt": ">", "amp": "&", "apos": "'", "quot": '"'}
_REFERENCE = regex(r"&(?:#(?P<decimal>[0-9]+);|#x(?P<hex>[0-9a-fA-F]+);|(?P<name>[^\s&;<>\"'#=,]{1,80});)?")
FORBIDDEN = regex("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")


def decode(source: Source, start: int, end: int, report: Report) -> Located:
    """The text between two offsets with character references replaced; nothing else is ever expanded."""
    text = source.text
    at = text.find("&", start, end)
    if at == -1:
        return source.located(start, end)
    parts: list[str] = []
    pieces: list[tuple[int, int]] = []
    length = 0
    copied = start

    def add(part: str, outer: int) -> None:
        nonlocal length
        if part:
            parts.append(part)
            pieces.append((length, outer))
            length += len(part)

    while at != -1:
        match = _REFERENCE.match(text, at, end)
        assert match is not None
        character = _character(match, report)
        if character is not None:
            add(text[copied:at], copied)
            add(character, at)
            copied = match.end()
        at = text.find("&", match.end(), end)
    add(text[copied:end], copied)
    return Located("".join(parts), Span(source, start, end), tuple(pieces) or None)


def _character(match: re.Match[str], report: Report) -> str | None:
    """The character that a reference stands for, or None when it must stay as it is written."""
    if match["name"]:
        if match["name"] not in PREDEFINED:
            report("entity", match.start(), match.end(), match["name"])
        return PREDEFINED.get(match["name"])
    digits = match["decimal"] or match["hex"]
    if not digits:
        report("bad-reference", match.start(), match.end(), "& must be written &amp;")
        return None
    digits = digits.lstrip("0")
    code = int(digits or "0", 10 if match["decimal"] else 16) if len(digits) < 9 else 0
    character = chr(code) if 0 < code <= 0x10FFFF else "\0"
    if FORBIDDEN.match(character):
        report("bad-reference", match.start(), match.end(), "not a character of XML")
        return None
    return character
