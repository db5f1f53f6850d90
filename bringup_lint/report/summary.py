"""The last words of a text report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from bringup_lint.finding import Applicability
from bringup_lint.finding import Severity
from bringup_lint.report.model import Report
from bringup_lint.report.paint import Paint


def summary(report: Report, width: int, paint: Paint) -> str:
    """What was found in how many files, and on further lines what is not shown or can be fixed."""
    counts = Counter(finding.severity for finding in report.shown)
    said = [paint(str(severity), _count(number, severity)) for severity, number in sorted(counts.items())]
    files = "1 file" if report.files == 1 else f"{report.files} files"
    if said:
        head = f"{', '.join(reversed(said))} in {files}"
    elif report.elsewhere:
        head = f"{paint('good', 'Nothing to report of the change')}: {files} checked"
    elif report.files:
        head = f"{paint('good', 'Clear for bring-up')}: {files} checked, nothing to report"
    else:
        head = "Nothing to check: no file of a known kind was found"
    return "\n".join((head, *(paint("faint", line) for line in _filled(_asides(report), width))))


def _asides(report: Report) -> Iterator[str]:
    fixes = Counter(finding.fix.applicability for finding in report.shown if finding.fix)
    if fixes[Applicability.SAFE]:
        yield f"{fixes[Applicability.SAFE]} fixable with --fix"
    if fixes[Applicability.UNSAFE]:
        yield f"{fixes[Applicability.UNSAFE]} fixable with --fix --unsafe-fixes"
    for severity, count in sorted(report.below.items(), reverse=True):
        if count:
            yield f"{count} more of severity {severity}: --min-severity {severity}"
    suppressed = sum(finding.suppression is not None for finding in report.findings)
    if suppressed:
        yield f"{suppressed} suppressed: --no-ignores"
    if report.elsewhere:
        yield f"{report.elsewhere} more in which the change has no part"
    if report.known:
        yield f"{len(report.known)} known to the baseline"


def _filled(asides: Iterator[str], width: int) -> list[str]:
    """The asides in as few lines as they need, none broken."""
    lines: list[str] = []
    for aside in asides:
        if lines and len(lines[-1]) + len(aside) + 3 <= width:
            lines[-1] += f" · {aside}"
        else:
            lines.append(aside)
    return lines


def _count(count: int, severity: Severity) -> str:
    return f"{count} {severity}" if count == 1 or severity is Severity.INFO else f"{count} {severity}s"
