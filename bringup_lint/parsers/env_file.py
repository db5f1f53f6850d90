"""Environment files as systemd reads them: the state machine of ``src/basic/env-file.c``, systemd.exec(5).

A comment is a line that starts with ``#`` or ``;``; there are no trailing comments and nothing is expanded.
Quotes count only where a value (or a part of it after another quoted one) starts; a quoted value may span lines.
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
_PLAIN = regex(r"[ \t]*(?P<value>(?:[^ \t\r\n\\'\"][^\r\n\\]*)?)(?=[\r\n]|\Z)")
"""A value without quotes at its start and without a backslash, as most are."""
_ESCAPED_IN_QUOTES = '"\\`$'


def parse(source: Source) -> EnvFile:
    """Read an environment file. Never raises; what systemd drops is in ``problems``: ``missing-equals``,
    ``bad-name``, ``export-prefix``, ``unterminated-quote``."""
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
    """The value, whether it is quoted, the offset of the line end after it, and the quote that is never closed."""
    if plain := _PLAIN.match(source.text, at):
        return _plain(source, at, plain), False, plain.end(), None
    reader = _ValueReader(source, at)
    end = reader.read()
    return reader.located(), reader.is_quoted, end, reader.quoted_from if reader.quote else None


def _plain(source: Source, at: int, found: re.Match[str]) -> Located:
    """A value that is written as it is; an empty one is where it could begin."""
    value = found["value"].rstrip(" \t")
    start = found.start("value") if value else at
    return source.located(start, start + len(value))


class _ValueReader:
    """The states of a value: before it starts, in it without quotes, and between quotes."""

    def __init__(self, source: Source, at: int) -> None:
        self.source = source
        self.first = self.at = at
        self.out: list[str] = []
        self.pieces: list[tuple[int, int]] = []
        """Offsets in ``out`` and in the file, where they do not go on together."""
        self.kept = 0
        """How much of ``out`` stays when trailing blanks are stripped: they go only after unquoted text."""
        self.started = False
        self.quote = ""
        self.quoted_from = 0
        self.is_quoted = False

    def read(self) -> int:
        """Read to the end of the line, or of the file where a quote is not closed; returns where that is."""
        text, size = self.source.text, len(self.source.text)
        while self.at < size:
            char = text[self.at]
            if self.quote:
                self.between_quotes(char)
            elif char in "\r\n":
                break
            else:
                self.without_quotes(char)
            self.at += 1
        if not self.quote:
            del self.out[self.kept :]
        return min(self.at, size)

    def push(self, char: str, offset: int) -> None:
        if not self.pieces or self.pieces[-1][1] + len(self.out) - self.pieces[-1][0] != offset:
            self.pieces.append((len(self.out), offset))
        self.out.append(char)

    def between_quotes(self, char: str) -> None:
        text = self.source.text
        if char == self.quote:
            self.quote, self.started, self.kept = "", False, len(self.out)
        elif self.quote == '"' and char == "\\" and self.at + 1 < len(text):
            self.at += 1
            escaped = text[self.at]
            if escaped not in _ESCAPED_IN_QUOTES and escaped != "\n":
                self.push("\\", self.at - 1)
            if escaped != "\n":
                self.push(escaped, self.at)
        else:
            self.push(char, self.at)

    def without_quotes(self, char: str) -> None:
        if char == "\\":
            self.escaped()
        elif not self.started and char in "'\"":
            self.quote, self.quoted_from, self.is_quoted = char, self.at, True
        elif self.started or char not in " \t":
            self.started = True
            self.push(char, self.at)
            if char not in " \t":
                self.kept = len(self.out)

    def escaped(self) -> None:
        """A backslash without quotes: it makes the next character literal, and joins the next line."""
        text = self.source.text
        self.at += 1
        self.started = True
        if self.at < len(text) and text[self.at] not in "\r\n":
            self.push(text[self.at], self.at)
        self.kept = len(self.out)

    def located(self) -> Located:
        pieces, length = self.pieces, len(self.out)
        begin = pieces[0][1] if pieces else self.first
        plain = self.is_quoted or any(outer - begin != inner for inner, outer in pieces)
        stop = pieces[-1][1] + length - pieces[-1][0] if pieces else begin
        span = self.source.span(begin, max(stop, begin))
        return Located("".join(self.out), span, tuple(pieces) if plain and pieces else None)
