"""Code frames as HTML: numbered lines, the marked stretches highlighted, what they mean below them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.finding.place import is_whole_file
from bringup_lint.report.frame import Frame
from bringup_lint.report.html.markup import code
from bringup_lint.report.html.markup import text
from bringup_lint.report.rows import Underline

LONG = 400
"""Of a longer line, this many characters are shown around its first mark."""
BEFORE = 80
WIDE = 96
"""A longer line is wrapped, and a note about it follows its mark; so is every line where there is less room."""


def figure(frame: Frame) -> str:
    """One file's lines below its place."""
    body = "".join(_lines(frame))
    held = f'<div class="code" tabindex="0">{body}</div>' if body else ""
    return f'<figure class="frame"><figcaption class="place">{text(frame.heading)}</figcaption>{held}</figure>'


def _lines(frame: Frame) -> Iterator[str]:
    for mark in frame.marks:
        if is_whole_file(mark.span) and mark.label:
            yield _note("", mark.label, f"{mark.style} under")
    previous = frame.lines[0] if frame.lines else 0
    for number in frame.lines:
        if number > previous + 1:
            yield '<div class="gap">⋯</div>'
        yield from _line(frame, number)
        previous = number


def _line(frame: Frame, number: int) -> Iterator[str]:
    line, marks = _cut(frame.source.line_text(number), sorted(frame.underlines.get(number, [])))
    bar = next((bar for bar in frame.bars if bar.first <= number <= bar.last), None)
    side = f" bar {bar.style}" if bar else ""
    side += " long" * (len(line) > WIDE)
    yield f'<div class="line{side}"><b>{number}</b><code>{"".join(_pieces(line, marks))}</code></div>'
    for mark in marks:
        if mark.label and len(line) <= WIDE:
            yield _note(line[: mark.start], mark.label, mark.style)
    if bar and bar.last == number and bar.label:
        yield _note("", bar.label, f"{bar.style} under")


def _note(before: str, label: str, style: str) -> str:
    indent = "".join("\t" if character == "\t" else " " for character in before)
    return f'<div class="note {style}"><b></b><code>{indent}</code><span>{text(" ".join(label.split()))}</span></div>'


def _cut(line: str, marks: list[Underline]) -> tuple[str, list[Underline]]:
    """A long line without what is far from its first mark."""
    if len(line) <= LONG:
        return line, marks
    start = max(marks[0].start - BEFORE, 0) if marks else 0
    end = start + LONG
    left, right = "…" * (start > 0), "…" * (end < len(line))
    shift = start - len(left)
    moved = [mark._replace(start=min(mark.start, end) - shift, end=min(mark.end, end) - shift) for mark in marks]
    return left + line[start:end] + right, moved


def _pieces(line: str, marks: list[Underline]) -> Iterator[str]:
    """The line with its marked stretches; where two overlap, the finding's own mark is seen."""
    cuts = sorted({0, len(line), *(at for mark in marks for at in (mark.start, mark.end))})
    yield from (_point(mark) for mark in marks if mark.start == mark.end == 0)
    for start, end in pairwise(cuts):
        covering = [mark for mark in marks if mark.start <= start and end <= mark.end]
        piece = code(line[start:end])
        if covering:
            style = min(covering, key=lambda mark: mark.style == "mark").style
            yield f'<mark class="{style}">{piece}</mark>'
        else:
            yield piece
        yield from (_point(mark) for mark in marks if mark.start == mark.end == end)
        yield from (_said(mark) for mark in marks if mark.end == end)


def _said(mark: Underline) -> str:
    """The note right after its mark, for a line that is wrapped."""
    label = text(" ".join(mark.label.split()))
    return f'<span class="said {mark.style}">{label}</span>' if label else ""


def _point(mark: Underline) -> str:
    return f'<mark class="{mark.style} point"></mark>'
