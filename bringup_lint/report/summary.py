"""The last words of a text report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from bringup_lint.finding import Applicability
from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.report.model import Report
from bringup_lint.report.paint import Paint

LONG = 20
"""Findings from which a report ends with a list of its rules."""
RULES = 12


def summary(report: Report, width: int, paint: Paint) -> str:
    """What was found in how many files, and on further lines what is not shown or can be fixed; before it, of a long
    report, the rules that found most."""
    shown = list(report.shown)
    counts = Counter(finding.severity for finding in shown)
    said = [paint(str(severity), _count(number, severity)) for severity, number in sorted(counts.items())]
    files = "1 file" if report.files == 1 else f"{report.files} files"
    if said:
        head = f"{', '.join(reversed(said))} in {_affected(shown, report.files)}{files}"
    elif report.elsewhere:
        head = f"{paint('good', 'Nothing to report of the change')}: {files} checked"
    elif report.files:
        head = f"{paint('good', 'Clear for bring-up')}: {files} checked, nothing to report"
    else:
        head = "Nothing to check: no file of a known kind was found"
    rules = list(_by_rule(shown)) if len(shown) > LONG else []
    return "\n".join((*rules, head, *(paint("faint", line) for line in _filled(_asides(report), width))))


def _affected(shown: list[Finding], files: int) -> str:
    """In how many of the files the findings are, unless in all."""
    affected = len({finding.source.name for finding in shown})
    return f"{affected} of " if affected < files else ""


def _by_rule(shown: list[Finding]) -> Iterator[str]:
    """The rules with the most findings, errors before warnings."""
    counts = Counter(finding.rule for finding in shown)
    worst: dict[str, Severity] = {}
    fixable: Counter[str] = Counter()
    for finding in shown:
        worst[finding.rule] = max(finding.severity, worst.get(finding.rule, finding.severity))
        fixable[finding.rule] += finding.fix is not None
    order = sorted(counts, key=lambda rule: (-worst[rule], -counts[rule], rule))
    yield "findings  rule"
    for rule in order[:RULES]:
        fixes = f", {fixable[rule]} fixable" if fixable[rule] else ""
        yield f"{counts[rule]:8}  {rule} ({worst[rule]}{fixes})"
    if len(order) > RULES:
        rest = sum(counts[rule] for rule in order[RULES:])
        yield f"{rest:8}  of {len(order) - RULES} more rules"
    yield ""


def _asides(report: Report) -> Iterator[str]:
    fixes = Counter(finding.fix.applicability for finding in report.shown if finding.fix)
    if fixes[Applicability.SAFE]:
        yield f"{fixes[Applicability.SAFE]} fixable with --fix"
    if fixes[Applicability.UNSAFE]:
        more = "more " if fixes[Applicability.SAFE] else ""
        yield f"{fixes[Applicability.UNSAFE]} {more}fixable with --fix --unsafe-fixes"
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
    if report.stale:
        yield f"{len(report.stale)} gone, but still in the baseline: --prune-baseline"


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
