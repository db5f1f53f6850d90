"""How text lies on a terminal: tabs, wide and combining characters, and those that must not reach it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import accumulate

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

TAB = 4
_REPLACEMENT = "\ufffd"
_COMMAND = regex(r"(##(?:vso)?)\[", re.I)
_START = regex(r"^(\s*)::(?!:)", re.M)
_BRACKET = "\u2045"
_ZERO_WIDTH = ("Mn", "Me")
_UNSAFE = ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp")


class Row(NamedTuple):
    """A line of text as a terminal shows it."""

    glyphs: Sequence[str]
    """What stands for each code point."""
    cells: Sequence[int]
    """The cell in which each code point starts, and the one after the last."""

    def cut(self, start: int, end: int) -> str:
        return "".join(self.glyphs[start:end])


def printable(text: str) -> str:
    """The text with visible signs for control characters, and without commands of CI runners, so that no file can
    speak to the terminal or to the runner that reads what is printed."""
    if "##" in text:
        text = without_commands(text)
    return text if text.isprintable() else "".join(map(_glyph, text))


def without_commands(text: str) -> str:
    """The text in which no bracket opens a command: GitHub's runner and Azure's agent look for them anywhere in a
    line (``ActionCommand.TryParse`` of actions/runner, ``Command.TryParse`` of azure-pipelines-agent)."""
    return _COMMAND.sub(lambda match: f"{match[1]}{_BRACKET}", text)


def plain_start(path: str) -> str:
    """A path at the start of a line, which GitHub's runner does not take for a command."""
    return f"./{path}" if path.lstrip().startswith("::") else path


def plain_starts(text: str) -> str:
    """Lines of prose of which none begins as a command of GitHub's runner: words of a file can, once wrapped."""
    return _START.sub("\\1∷", text) if "::" in text else text


def laid_out(line: str) -> Row:
    """A line without its line end, tabs expanded."""
    if "##" in line:
        line = without_commands(line)
    if line.isascii() and line.isprintable():
        return Row(line, range(len(line) + 1))
    glyphs = []
    cell = 0
    widths = [0]
    for character in line:
        glyph = " " * (TAB - cell % TAB) if character == "\t" else _glyph(character)
        width = len(glyph) if glyph.isascii() else _width(glyph)
        glyphs.append(glyph)
        widths.append(width)
        cell += width
    return Row(glyphs, list(accumulate(widths)))


def _glyph(character: str) -> str:
    if character.isprintable():
        return character
    if character < " ":
        return chr(0x2400 + ord(character))
    if character == "\x7f":
        return "␡"
    from unicodedata import category

    return _REPLACEMENT if category(character) in _UNSAFE else " "


def _width(glyph: str) -> int:
    from unicodedata import category
    from unicodedata import east_asian_width

    if category(glyph) in _ZERO_WIDTH:
        return 0
    return 2 if east_asian_width(glyph) in "WF" else 1
