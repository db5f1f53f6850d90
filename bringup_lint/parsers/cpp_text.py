"""C++ text without its comments, and without what stands in its strings; every character keeps its place."""

from __future__ import annotations

import re
from collections.abc import Iterator

_PIECES = re.compile(
    r"R\"(?P<mark>[^ ()\\\t\n]{0,16})\((?P<raw>.*?)\)(?P=mark)\""
    r"|\"(?P<text>(?:\\.|[^\"\\\n])*)\""
    r"|'(?:\\.|[^'\\\n])'"
    r"|(?P<comment>//[^\n]*|/\*.*?(?:\*/|\Z))",
    re.S,
)
_OPENING, _CLOSING = "([{", ")]}"


def blanked(text: str) -> tuple[str, str]:
    """The text with blanks for comments, and the same with blanks also for what stands between quotes."""
    code: list[str] = []
    bare: list[str] = []
    at = 0
    for piece in _PIECES.finditer(text):
        between = text[at : piece.start()]
        code.append(between)
        bare.append(between)
        whole = piece[0]
        empty = re.sub(r"[^\n]", " ", whole)
        code.append(empty if piece["comment"] is not None else whole)
        bare.append(f'"{empty[1:-1]}"' if piece["comment"] is None and len(whole) > 1 else empty)
        at = piece.end()
    return "".join([*code, text[at:]]), "".join([*bare, text[at:]])


def arguments(bare: str, start: int) -> tuple[list[tuple[int, int]], int] | None:
    """Where the arguments of a call stand whose opening parenthesis is just before ``start``, and where the call ends;
    None when it does not."""
    found: list[tuple[int, int]] = []
    level, angles, begin = 0, 0, start
    for at in range(start, min(len(bare), start + 4000)):
        char = bare[at]
        if char in _OPENING:
            level += 1
        elif char in _CLOSING:
            if level == 0:
                if bare[begin:at].strip():
                    found.append((begin, at))
                return found, at + 1
            level -= 1
        elif char == "<" and bare[at - 1].isalnum():
            angles += 1
        elif char == ">" and angles and bare[at - 1] != "-":
            angles -= 1
        elif char == "," and level == 0 and angles == 0:
            found.append((begin, at))
            begin = at + 1
    return None


def template_end(bare: str, start: int) -> int | None:
    """Where the ``>`` stands that closes a template argument beginning at ``start``."""
    level = 0
    for at in range(start, min(len(bare), start + 400)):
        if bare[at] == "<":
            level += 1
        elif bare[at] == ">":
            if level == 0:
                return at
            level -= 1
        elif bare[at] in ";{}":
            return None
    return None


def trimmed(text: str, spans: list[tuple[int, int]]) -> Iterator[tuple[int, int]]:
    """The spans without the blanks at their ends."""
    for start, end in spans:
        inner = text[start:end]
        yield start + len(inner) - len(inner.lstrip()), end - len(inner) + len(inner.rstrip())
