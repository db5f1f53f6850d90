"""The report for people: code frames with carets, advice, and a summary."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.finding import Applicability
from bringup_lint.finding import Finding
from bringup_lint.finding.copies import COPIED
from bringup_lint.finding.place import place_of
from bringup_lint.report.columns import printable
from bringup_lint.report.frame import Mark
from bringup_lint.report.frame import draw
from bringup_lint.report.frame import frames
from bringup_lint.report.model import Part
from bringup_lint.report.model import Report
from bringup_lint.report.order import LONG
from bringup_lint.report.order import by_cause
from bringup_lint.report.paint import Paint
from bringup_lint.report.paint import painter
from bringup_lint.report.summary import ending
from bringup_lint.report.wrap import wrap
from bringup_lint.source import Span

NARROW = 40
WIDE = 120
"""Prose is not set wider than this, however wide the terminal is."""


def render(report: Report) -> str:
    paint = painter(report.colour)
    width = max(report.width, NARROW)
    blocks = () if report.part is Part.STATISTICS else ("\n".join(lines) for lines in _blocks(report, width, paint))
    last = () if report.part is Part.FINDINGS else (ending(report, min(width, WIDE), paint),)
    told = [*blocks, *last]
    if told:
        told[-1] += "\n"
    return "\n\n".join(told)


def _blocks(report: Report, width: int, paint: Paint) -> Iterator[Iterator[str]]:
    """The findings in the order of their places; many of them by cause, where what is the same is said once."""
    shown = list(report.shown)
    if len(shown) <= LONG:
        yield from (block(finding, width, paint) for finding in shown)
        return
    for first, *others in by_cause(shown, report.at_boot):
        yield block(first, width, paint)
        yield from (block(finding, width, paint, above=first) for finding in others)


def block(finding: Finding, width: int, paint: Paint, above: Finding | None = None) -> Iterator[str]:
    """The lines that tell one finding; without the advice that one of the same rule ``above`` gives as well."""
    style = str(finding.severity)
    yield from _headline(finding, style, min(width, WIDE), paint)
    related = (Mark(span, "mark", message) for span, message in finding.related if message != COPIED)
    marks = [Mark(finding.span, style), *related]
    shown = frames(marks)
    gutter = max(len(str(frame.lines[-1])) if frame.lines else 1 for frame in shown)
    edge = paint("frame", f"{'':{gutter}} |")
    for number, frame in enumerate(shown):
        yield f"{'':{gutter}}{paint('frame', ':::' if number else '-->')} {frame.heading}"
        yield from draw(frame, gutter, width, paint)
        if frame.lines:
            yield edge
    told = set(_notes(above)) if above else ()
    for name, text in _notes(finding):
        if (name, text) not in told:
            yield from _note(name, text, gutter, min(width, WIDE), paint)
    if above is None:
        edge = f"{'':{gutter}} {paint('frame', '=')}"
        yield f"{edge} {paint('strong', 'docs:')} bringup-lint explain {finding.rule}"


def _headline(finding: Finding, style: str, width: int, paint: Paint) -> Iterator[str]:
    name = f"{style}[{finding.rule}]"
    first, *more = wrap(f"{name}: {printable(' '.join(finding.message.split()))}", width - 2)
    yield f"{paint(style, first[: len(name)])}{paint('strong', first[len(name) :])}"
    yield from (f"  {paint('strong', line)}" for line in more)


def _notes(finding: Finding) -> Iterator[tuple[str, str]]:
    copies = [_place(span) for span, message in finding.related if message == COPIED]
    if copies:
        yield "copies", "\n".join(copies)
    if finding.chain:
        yield "path", "\n".join(_steps(finding))
    if finding.advice:
        yield "help", finding.advice
    if finding.fix:
        safe = finding.fix.applicability is Applicability.SAFE
        yield "fix", f"{finding.fix.title} ({'--fix' if safe else '--fix --unsafe-fixes'})"


def _steps(finding: Finding) -> Iterator[str]:
    for number, (span, message) in enumerate(finding.chain, 1):
        yield f"{number}. {message}"
        yield f"   {_place(span)}"


def _place(span: Span) -> str:
    """``path:line:column``, as editors understand it."""
    place = place_of(span)
    return f"{span.path}:{place.line}:{place.column}"


def _note(name: str, text: str, gutter: int, width: int, paint: Paint) -> Iterator[str]:
    head = f"{'':{gutter}} {paint('frame', '=')} {paint('strong', name + ':')} "
    indent = gutter + 5 + len(name)
    lines = [line for part in text.splitlines() or [""] for line in wrap(printable(part), width - indent)]
    yield head + lines[0]
    yield from (" " * indent + line for line in lines[1:])
