"""One line of a code frame: cut to the room there is, with carets and labels under it."""

from __future__ import annotations

from bisect import bisect_left
from bisect import bisect_right
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.report.columns import laid_out
from bringup_lint.report.columns import printable
from bringup_lint.report.paint import Paint
from bringup_lint.report.wrap import wrap

LABEL = 36
"""A label with fewer cells than this to the right of its mark goes below it."""
FAR = 1000
"""Code points to each side of a mark that are looked at, however long the line is."""


class Underline(NamedTuple):
    """A stretch of one line, as offsets in it or as cells on the terminal."""

    start: int
    end: int
    style: str
    label: str


class Bar(NamedTuple):
    """A mark over several lines, drawn at their left; it ends before offset ``end`` of the last line."""

    first: int
    last: int
    end: int
    style: str
    label: str


def rows(line: str, marks: list[Underline], room: int) -> Iterator[tuple[str, list[Underline]]]:
    """The line cut to the room, with its marks in cells; once more for marks too far from the first."""
    if len(line) <= min(room, FAR) and line.isascii() and line.isprintable() and "##" not in line:
        yield line, marks
        return
    pending = marks or [Underline(0, 0, "", "")]
    while pending:
        first = pending[0]
        base = max(first.start - FAR, 0)
        piece = line[base : first.start + FAR]
        row = laid_out(piece)
        start, end = _window(row.cells, first.start - base, min(first.end - base, len(piece)), room)
        cut_left, cut_right = base + start > 0, base + end < len(line)
        shift = row.cells[start] - cut_left
        inside = [mark for mark in pending if base + start <= mark.start <= base + end]
        placed = [
            mark._replace(
                start=row.cells[mark.start - base] - shift,
                end=row.cells[min(mark.end - base, end)] - shift,
            )
            for mark in inside
        ]
        yield "…" * cut_left + row.cut(start, end) + "…" * cut_right, placed if marks else []
        pending = [mark for mark in pending if mark not in inside]


def _window(cells: Sequence[int], start: int, end: int, room: int) -> tuple[int, int]:
    """The offsets between which a line is shown, so that the mark from ``start`` to ``end`` is seen."""
    size = len(cells) - 1
    if cells[size] <= room:
        return 0, size
    left = 0
    if cells[end] > room - 1:
        lead = max(4, min(room // 4, room - 2 - (cells[end] - cells[start])))
        left = bisect_left(cells, min(cells[start] - lead, cells[size] - room + 1))
    right = bisect_right(cells, cells[left] + room - 1 - (left > 0)) - 1
    return left, size if cells[size] - cells[left] <= room - (left > 0) else right


def underlined(marks: list[Underline], room: int, paint: Paint) -> Iterator[str]:
    """The lines below a line of code: carets or dashes, and what they mean. The label of the last mark is
    beside it where there is room, the others below their marks, from right to left."""
    pending = sorted(marks)
    while pending:
        row: list[Underline] = []
        at, drawn = 0, ""
        for mark in pending:
            if mark.start < at or (row and mark.start == at and mark.style == row[-1].style):
                continue
            width = max(mark.end - mark.start, 1)
            drawn += " " * (mark.start - at) + paint(mark.style, ("-" if mark.style == "mark" else "^") * width)
            at = mark.start + width
            row.append(mark)
        yield from _labelled(drawn, at, row[-1], room, paint)
        for mark in reversed(row[:-1]):
            yield from _below(mark, room, paint)
        pending = [mark for mark in pending if not any(mark is shown for shown in row)]


def closing(line: str, bar: Bar, room: int, paint: Paint) -> Iterator[str]:
    """The lines that close the bar of a stretch of several lines."""
    cells = laid_out(line[: room + 1]).cells
    at = min(cells[min(max(bar.end - 1, 0), len(cells) - 1)], room - 1)
    sign = "-" if bar.style == "mark" else "^"
    drawn = paint(bar.style, f"|_{'_' * at}{sign}")
    yield from _labelled(drawn, at + 3, Underline(at + 2, at + 3, bar.style, bar.label), room + 2, paint)


def _labelled(drawn: str, at: int, mark: Underline, room: int, paint: Paint) -> Iterator[str]:
    """The drawn marks with the label of the last one, which ends at cell ``at``."""
    beside = room - at - 1
    if not mark.label or (len(mark.label) > beside and beside < LABEL):
        yield drawn
        yield from _below(mark, room, paint)
        return
    first, *more = _set(mark, beside, paint)
    yield f"{drawn} {first}"
    yield from (" " * (at + 1) + line for line in more)


def _below(mark: Underline, room: int, paint: Paint) -> Iterator[str]:
    if mark.label:
        indent = max(0, min(mark.start, room - min(len(mark.label), LABEL)))
        yield from (" " * indent + line for line in _set(mark, room - indent, paint))


def _set(mark: Underline, width: int, paint: Paint) -> Iterator[str]:
    style = "label" if mark.style == "mark" else mark.style
    return (paint(style, line) for line in wrap(printable(" ".join(mark.label.split())), width))
