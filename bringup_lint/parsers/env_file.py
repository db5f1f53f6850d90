"""Environment files as systemd reads them: the state machine of ``src/basic/env-file.c``, systemd.exec(5).

A comment is a line that starts with ``#`` or ``;``; there are no trailing comments and nothing is expanded.
Quotes count only
where a value (or a part of it behind another quoted one) starts; a quoted value may span lines.
"""

from __future__ import annotations

import re

from bringup_lint.model.env_file import Entry
from bringup_lint.model.env_file import EnvFile
from bringup_lint.parsers.matching import end_of
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

_NAME = regex(r"[A-Za-z_][A-Za-z0-9_]*")
_BLANK = " \t\r\n"
_LINE = regex(r"[^\r\n]*")
_COMMENT = regex(r"(?:\\.|[^\\\r\n])*", re.S)
"""A backslash at the end of a comment joins the next line to it."""
_ESCAPED_IN_QUOTES = '"\\`$'


def parse(source: Source) -> EnvFile:
    """Read an environment file. Never raises; what systemd drops is in ``problems``: ``missing-equals``,
    ``bad-name``,
    ``export-prefix``, ``unterminated-quote``."""
    file = EnvFile(source)
    text = source.text
    at = 1 if text.startswith("\ufeff") else 0
    size = len(text)
    while at < size:
        if text[at] in _BLANK:
            at += 1
            continue
        end = end_of(_LINE, text, at)
        if text[at] in "#;":
            at = end_of(_COMMENT, text, at) + 1
            continue
        equals = text.find("=", at, end)
        if equals == -1:
            file.problems.append(Problem("missing-equals", source.located(at, end).strip_located(_BLANK)))
            at = end + 1
            continue
        at = _entry(file, at, equals)
    return file


def _entry(file: EnvFile, start: int, equals: int) -> int:
    """Read the entry at ``start``; returns where the next line starts."""
    source = file.source
    name = source.located(start, equals).strip_located(_BLANK)
    value, quoted, end, open_quote = _value(source, equals + 1)
    if open_quote is not None:
        file.problems.append(Problem("unterminated-quote", source.located(open_quote, end)))
    if _NAME.fullmatch(name):
        file.entries.append(Entry(name, value, source.span(start, end), quoted))
    elif name.startswith(("export ", "export\t")) and _NAME.fullmatch(name[7:].strip()):
        file.problems.append(Problem("export-prefix", name.part(0, 6), name[7:].strip()))
    else:
        file.problems.append(Problem("bad-name", name))
    return end + 1


def _value(source: Source, at: int) -> tuple[Located, bool, int, int | None]:
    """The value, whether it is quoted, the offset of the line end behind it, and the quote that is never
    closed."""
    text, size = source.text, len(source.text)
    out: list[str] = []
    pieces: list[tuple[int, int]] = []
    first = at
    quote, quoted_from, quoted = "", 0, False
    started = False
    kept = 0
    """How much of ``out`` stays when trailing blanks are stripped: they go only behind unquoted text."""

    def push(char: str, offset: int) -> None:
        if not pieces or pieces[-1][1] + len(out) - pieces[-1][0] != offset:
            pieces.append((len(out), offset))
        out.append(char)

    while at < size:
        char = text[at]
        if quote:
            if char == quote:
                quote, started = "", False
                kept = len(out)
            elif quote == '"' and char == "\\" and at + 1 < size:
                at += 1
                if text[at] not in _ESCAPED_IN_QUOTES and text[at] != "\n":
                    push("\\", at - 1)
                if text[at] != "\n":
                    push(text[at], at)
            else:
                push(char, at)
        elif char in "\r\n":
            break
        elif char == "\\":
            at += 1
            started = True
            if at < size and text[at] not in "\r\n":
                push(text[at], at)
            kept = len(out)
        elif not started and char in "'\"":
            quote, quoted_from, quoted = char, at, True
        elif started or char not in " \t":
            started = True
            push(char, at)
            if char not in " \t":
                kept = len(out)
        at += 1
    end = min(at, size)
    open_quote = quoted_from if quote else None
    if open_quote is None:
        del out[kept:]
    begin = pieces[0][1] if pieces else first
    plain = quoted or any(outer - begin != inner for inner, outer in pieces)
    stop = pieces[-1][1] + len(out) - pieces[-1][0] if pieces else begin
    span = source.span(begin, max(stop, begin))
    return Located("".join(out), span, tuple(pieces) if plain and pieces else None), quoted, end, open_quote
