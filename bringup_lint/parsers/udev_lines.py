"""Physical lines of a udev rules file to logical ones, as ``udev_rules_parse_file`` of systemd joins them."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

BLANKS = " \t\n\r"
MAXIMUM_LENGTH = 16 * 1024
"""Longest line that udev reads, in bytes (``UDEV_LINE_SIZE``)."""

_LINE = regex(r"([^\n\r\0]*)(?:\r\n|\n\r|[\n\r\0]|\Z)")


class LogicalLine(NamedTuple):
    text: Located
    """Continued lines joined; the position of every character is known."""
    problem: Problem | None


def logical_lines(source: Source) -> Iterator[LogicalLine]:
    """Rule lines without comments. A comment between continued lines is skipped and does not end the rule."""
    pieces: list[tuple[int, int]] = []
    continued = False
    for start, end in _physical_lines(source.text):
        text = source.text
        while start < end and text[start] in BLANKS:
            start += 1
        if text.startswith("#", start, end):
            continue
        continued = end > start and text[end - 1] == "\\"
        pieces.append((start, end - continued))
        if continued:
            continue
        line = _joined(source, pieces)
        pieces = []
        if line:
            yield LogicalLine(line, _too_long(line))
    if pieces:
        line = _joined(source, pieces)
        last = pieces[-1][1]
        yield LogicalLine(line, Problem("end-of-file-in-rule", source.span(last, min(last + 1, len(source.text)))))


def _physical_lines(text: str) -> Iterator[tuple[int, int]]:
    at = 0
    while at < len(text):
        found = _LINE.match(text, at)
        assert found is not None
        yield found.span(1)
        at = max(found.end(), at + 1)


def _joined(source: Source, spans: list[tuple[int, int]]) -> Located:
    if len(spans) == 1:
        return source.located(*spans[0])
    pieces: list[tuple[int, int]] = []
    texts: list[str] = []
    length = 0
    for start, end in spans:
        if end > start:
            pieces.append((length, start))
            texts.append(source.text[start:end])
            length += end - start
    first = pieces[0][1] if pieces else spans[0][0]
    last = pieces[-1][1] + len(texts[-1]) if pieces else first
    return Located("".join(texts), source.span(first, last), tuple(pieces))


def _too_long(line: Located) -> Problem | None:
    if len(line) * 4 < MAXIMUM_LENGTH or len(line.encode(errors="replace")) < MAXIMUM_LENGTH:
        return None
    return Problem("line-too-long", line.part(0, 1), str(len(line)))
