"""Where a span is, as people count."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span


class Place(NamedTuple):
    """Counted from 1, columns in code points; the end is exclusive, on the line of the last character."""

    line: int
    column: int
    end_line: int
    end_column: int


def inside(span: Span) -> Span:
    """The part of a span that its text really holds."""
    size = len(span.source.text)
    if 0 <= span.start <= span.end <= size:
        return span
    start = min(max(span.start, 0), size)
    return span._replace(start=start, end=min(max(span.end, start), size))


def place_of(span: Span) -> Place:
    span = inside(span)
    end_line, end_column = span.end_position
    after = len(span.source.line_text(end_line)) + 1
    return Place(*span.source.position(span.start), end_line, min(end_column, after))


def is_whole_file(span: Span) -> bool:
    """True when a span stands for the file itself and not for a stretch of it."""
    return span.start <= 0 and span.end <= 0
