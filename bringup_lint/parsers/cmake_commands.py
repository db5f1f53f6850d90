"""The commands of a CMakeLists.txt with their arguments, as they are written."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

_COMMAND = regex(r"([A-Za-z_]\w*)[ \t]*\(")
_TOKEN = regex(
    r"(?P<skip>\s+|\#\[(?P<hash>=*)\[.*?(?:\](?P=hash)\]|\Z)|\#[^\n]*)"
    r"|\[(?P<eq>=*)\[(?P<bracket>.*?)\](?P=eq)\]"
    r'|"(?P<quoted>(?:[^"\\]|\\.)*)"'
    r"|(?P<paren>[()])"
    r'|(?P<plain>(?:[^\s()\#"\\]|\\.)+)',
    re.S,
)
_SKIP = regex(r"(?:\s+|\#\[(?P<hash>=*)\[.*?(?:\](?P=hash)\]|\Z)|\#[^\n]*)+", re.S)


class Command(NamedTuple):
    name: str
    arguments: list[Located]
    depth: int
    """How many ``if``, loops and functions it is in."""

    @property
    def conditional(self) -> bool:
        return self.depth > 0


def commands(source: Source) -> list[Command]:
    """The commands in order; read once for all that ask."""
    return source.once(commands, lambda: list(_commands(source)))


def _commands(source: Source) -> Iterator[Command]:
    text = source.text
    at = depth = 0
    while True:
        skipped = _SKIP.match(text, at)
        at = skipped.end() if skipped else at
        match = _COMMAND.match(text, at)
        if match is None:
            next_line = text.find("\n", at)
            if next_line < 0:
                return
            at = next_line + 1
            continue
        arguments, at = _arguments(source, match.end())
        name = match[1].lower()
        if name in ("endif", "endforeach", "endfunction", "endmacro", "endwhile"):
            depth -= 1
        yield Command(name, arguments, depth)
        if name in ("if", "foreach", "function", "macro", "while"):
            depth += 1


def _arguments(source: Source, at: int) -> tuple[list[Located], int]:
    arguments: list[Located] = []
    level = 1
    text = source.text
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            at += 1
            continue
        at = match.end()
        if match["paren"]:
            level += 1 if match["paren"] == "(" else -1
            if level == 0:
                break
        for group in ("quoted", "bracket", "plain"):
            if match[group] is not None:
                arguments.append(Located(match[group], Span(source, *match.span(group))))
    return arguments, at
