"""One line a finding: ``path:line:column: severity[rule] message``."""

from __future__ import annotations

from bringup_lint.finding import Finding
from bringup_lint.finding.place import inside
from bringup_lint.report.columns import plain_start
from bringup_lint.report.columns import printable
from bringup_lint.report.model import Report


def render(report: Report) -> str:
    return "".join(map(line, report.shown))


def line(finding: Finding) -> str:
    row, column = finding.source.position(inside(finding.span).start)
    place = f"{plain_start(finding.source.name)}:{row}:{column}"
    message = " ".join(finding.message.split())
    return printable(f"{place}: {finding.severity}[{finding.rule}] {message}") + "\n"
