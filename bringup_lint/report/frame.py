"""Code frames: the lines of a file that a finding speaks of, numbered, with marks under what is meant."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.finding.place import is_whole_file
from bringup_lint.finding.place import place_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.report.columns import printable
from bringup_lint.report.paint import Paint
from bringup_lint.report.rows import Bar
from bringup_lint.report.rows import Underline
from bringup_lint.report.rows import closing
from bringup_lint.report.rows import rows
from bringup_lint.report.rows import underlined
from bringup_lint.report.wrap import wrap
from bringup_lint.source import Source
from bringup_lint.source import Span

TALL = 6
"""A stretch of more lines than this is shown without its middle."""


class Mark(NamedTuple):
    """A stretch to show; the style is the severity of the finding, or ``mark`` for a related place."""

    span: Span
    style: str
    label: str = ""


class Frame(NamedTuple):
    """The marked lines of one file."""

    source: Source
    marks: list[Mark]
    lines: list[int]
    underlines: dict[int, list[Underline]]
    bars: list[Bar]

    @property
    def heading(self) -> str:
        """``path:line:column`` of the first mark, as editors understand it."""
        name, first = printable(self.source.name), self.marks[0].span
        return name if is_whole_file(first) else "{}:{}:{}".format(name, *place_of(first))


def frames(marks: Iterable[Mark]) -> list[Frame]:
    """One frame a file, in the order in which the marks name them."""
    by_source: dict[Source, list[Mark]] = {}
    for mark in marks:
        by_source.setdefault(mark.span.source, []).append(mark)
    return [_frame(source, marks) for source, marks in by_source.items()]


def _frame(source: Source, marks: list[Mark]) -> Frame:
    underlines: dict[int, list[Underline]] = {}
    bars: list[Bar] = []
    lines: set[int] = set()
    for mark in marks:
        if is_whole_file(mark.span):
            continue
        place = place_of(mark.span)
        first, last = place.line, place.end_line
        if mark.style != "mark":
            lines.update(_around(source, first, last))
        if last > first and not any(bar.first <= last and first <= bar.last for bar in bars):
            bars.append(Bar(first, last, place.end_column - 1, mark.style, mark.label))
            lines.update((first, first + 1, last) if last - first >= TALL else range(first, last + 1))
            continue
        size = len(source.line_text(first))
        end = place.end_column - 1 if last == first else size
        underline = Underline(min(place.column - 1, size), min(end, size), mark.style, mark.label)
        underlines.setdefault(first, []).append(underline)
        lines.add(first)
    lines.update([line + 1 for line in lines if line + 2 in lines])
    return Frame(source, marks, sorted(lines), underlines, bars)


def _around(source: Source, first: int, last: int) -> Iterator[int]:
    for line in (first - 1, last + 1):
        if 1 <= line <= len(source.line_starts) and source.line_text(line).strip():
            yield line


def draw(frame: Frame, gutter: int, width: int, paint: Paint) -> Iterator[str]:
    """The lines of a frame below its heading; ``gutter`` is the width of the line numbers."""
    edge = paint("frame", f"{'':{gutter}} |")
    room = max(width - gutter - 3 - 2 * bool(frame.bars), 20)
    for mark in frame.marks:
        if is_whole_file(mark.span) and mark.label:
            yield from (f"{edge} {paint('label', line)}" for line in wrap(printable(mark.label), room))
    if frame.lines:
        yield edge
    previous = frame.lines[0] if frame.lines else 0
    for number in frame.lines:
        if number > previous + 1:
            bar = _bar_over(frame, previous, number)
            yield paint("frame", "...") + (" " * gutter + paint(bar.style, "|") if bar else "")
        for text, marks in rows(frame.source.line_text(number), frame.underlines.get(number, []), room):
            row = _side(frame, number, paint, number) + text
            yield f"{paint('frame', f'{number:>{gutter}} |')} {row}".rstrip()
            beside = _side(frame, number, paint)
            yield from (f"{edge} {beside}{line}" for line in underlined(marks, room, paint))
        for bar in frame.bars:
            if bar.last == number:
                last = frame.source.line_text(number)
                yield from (f"{edge} {line}" for line in closing(last, bar, room, paint))
        previous = number


def _bar_over(frame: Frame, first: int, last: int) -> Bar | None:
    return next((bar for bar in frame.bars if bar.first <= first and last <= bar.last), None)


def _side(frame: Frame, number: int, paint: Paint, opening: int = 0) -> str:
    """What is between the edge and a line: the bar that covers it, which begins at line ``opening``."""
    if not frame.bars:
        return ""
    bar = _bar_over(frame, number, number)
    return f"{paint(bar.style, '/' if bar.first == opening else '|')} " if bar else "  "
