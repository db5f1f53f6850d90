"""One line a finding: ``path:line:column: severity[rule] message``, and where else the same is to be found."""

from __future__ import annotations

from bringup_lint.finding import Finding
from bringup_lint.finding.copies import COPIED
from bringup_lint.finding.copies import REPEATED
from bringup_lint.finding.place import inside
from bringup_lint.report.columns import plain_start
from bringup_lint.report.columns import printable
from bringup_lint.report.model import Report
from bringup_lint.source import Span


def render(report: Report) -> str:
    return "".join(map(line, report.shown))


def line(finding: Finding) -> str:
    message = " ".join(finding.message.split())
    others = [_position(each.span) for each in finding.related if each.message == REPEATED]
    others += [_place(each.span) for each in finding.related if each.message == COPIED]
    also = f" (also at {', '.join(others)})" if others else ""
    return printable(f"{_place(finding.span)}: {finding.severity}[{finding.rule}] {message}{also}") + "\n"


def _place(span: Span) -> str:
    """``path:line:column``."""
    return f"{plain_start(span.source.name)}:{_position(span)}"


def _position(span: Span) -> str:
    """``line:column``."""
    row, column = span.source.position(inside(span).start)
    return f"{row}:{column}"
