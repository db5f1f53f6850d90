"""The last words of a text report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from bringup_lint.finding import Severity
from bringup_lint.report.model import Report
from bringup_lint.report.paint import Paint


def summary(report: Report, paint: Paint) -> str:
    counts = Counter(finding.severity for finding in report.shown)
    said = [paint(str(severity), _count(number, severity)) for severity, number in sorted(counts.items())]
    asides = "".join(f" ({aside})" for aside in _asides(report))
    files = _files(report.files)
    if said:
        return f"{', '.join(reversed(said))} in {files}{asides}"
    if report.files:
        return f"{paint('good', 'Clear for bring-up')}: {files} checked, nothing to report{asides}"
    return f"Nothing to check: no file of a known kind was found{asides}"


def _asides(report: Report) -> Iterator[str]:
    for severity, count in sorted(report.below.items(), reverse=True):
        if count:
            yield f"{count} more of severity {severity}: --min-severity {severity}"
    suppressed = sum(finding.suppression is not None for finding in report.findings)
    if suppressed:
        yield f"{suppressed} suppressed: --no-ignores"
    if report.known:
        yield f"{report.known} known to the baseline"


def _count(count: int, severity: Severity) -> str:
    plural = "" if count == 1 or severity is Severity.INFO else "s"
    return f"{count} {severity}{plural}"


def _files(count: int) -> str:
    return "1 file" if count == 1 else f"{count} files"
