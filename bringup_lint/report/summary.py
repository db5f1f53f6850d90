"""The last words of a text report."""

from __future__ import annotations

from collections import Counter
from collections import defaultdict
from collections.abc import Iterator

from bringup_lint.finding import Applicability
from bringup_lint.finding import Finding
from bringup_lint.plural import counted
from bringup_lint.plural import of_severity
from bringup_lint.report.columns import printable
from bringup_lint.report.model import Part
from bringup_lint.report.model import Report
from bringup_lint.report.paint import Paint

FEW = 5
"""Findings up to which a report needs no list of its rules."""
RULES = 12
"""Rules that the list at the end of a report names."""


def ending(report: Report, width: int, paint: Paint) -> str:
    """The summary, after a table of the rules where that is asked for or there is much to read."""
    return "\n".join((*_table(report, paint), summary(report, width, paint)))


def _table(report: Report, paint: Paint) -> Iterator[str]:
    shown = list(report.shown)
    if shown and report.part is Part.STATISTICS:
        yield from by_rule(shown, paint)
    elif len(shown) > FEW:
        yield from by_rule(shown, paint, RULES)


def summary(report: Report, width: int, paint: Paint) -> str:
    """What was found in how many files, and on further lines what is not shown or can be fixed."""
    shown = list(report.shown)
    counts = Counter(finding.severity for finding in shown)
    said = [paint(str(severity), of_severity(number, str(severity))) for severity, number in sorted(counts.items())]
    files = counted(report.files, "file")
    if said and not report.files:
        head = f"{', '.join(reversed(said))}: no file was checked"
    elif said:
        head = f"{', '.join(reversed(said))} in {_affected(shown, report.files)}{files}"
    elif report.elsewhere:
        head = f"{paint('good', 'Nothing to report of the change')}: {files} checked"
    elif report.files:
        head = f"{paint('good', 'Clear for bring-up')}: {files} checked, nothing to report"
    else:
        head = "Nothing to check: no file of a known kind was found"
    return "\n".join((head, *(paint("faint", line) for line in _filled(_asides(report), width))))


def _affected(shown: list[Finding], files: int) -> str:
    """In how many of the files the findings are, unless in all."""
    affected = len({finding.source.name for finding in shown})
    return f"{affected} of " if affected < files else ""


def by_rule(shown: list[Finding], paint: Paint, limit: int | None = None) -> Iterator[str]:
    """A table of the rules, errors before warnings, and of these the one with the most findings first."""
    found: dict[str, list[Finding]] = defaultdict(list)
    for finding in shown:
        found[finding.rule].append(finding)
    rows = [(max(each.severity for each in group), len(group), rule, group) for rule, group in found.items()]
    rows.sort(key=lambda row: (-row[0], -row[1], row[2]))
    cells = [(str(count), str(worst), _fixable(group), rule) for worst, count, rule, group in rows[:limit]]
    left = sum(count for _, count, _, _ in rows[len(cells) :])
    if left:
        cells.append((str(left), "", "", f"of {counted(len(rows) - len(cells), 'more rule')}"))
    yield from _columns([("findings", "severity", "fixable", "rule"), *cells], paint)
    yield ""


def _fixable(group: list[Finding]) -> str:
    """How many of the findings a fix removes, and whether it is safe."""
    fixes = Counter(finding.fix.applicability for finding in group if finding.fix)
    return ", ".join(f"{count} {kind}" for kind, count in sorted(fixes.items()))


def _columns(rows: list[tuple[str, str, str, str]], paint: Paint) -> Iterator[str]:
    """Rows below a head, with the severities in their colours."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    for number, (count, severity, fixable, rule) in enumerate(rows):
        style = severity if number and severity else "faint"
        worst = paint(style, f"{severity:<{widths[1]}}")
        row = f"{count:>{widths[0]}}  {worst}  {fixable:<{widths[2]}}  {rule}"
        yield row if number else paint("faint", f"{count}  {severity:<{widths[1]}}  {fixable:<{widths[2]}}  {rule}")


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
    if said := suppressed(report):
        yield f"{said}: --no-ignores"
    yield from report.narrowed
    if report.elsewhere:
        yield f"{report.elsewhere} more in which the change has no part"
    if report.known:
        yield f"{len(report.known)} known to the baseline"
    if report.stale:
        yield f"{len(report.stale)} gone, but still in the baseline: --prune-baseline"


def suppressed(report: Report) -> str:
    """How many findings are suppressed, and by what; empty when none is."""
    return printable(", ".join(f"{number} suppressed by {what}" for what, number in report.silenced))


def _filled(asides: Iterator[str], width: int) -> list[str]:
    """The asides in as few lines as they need, none broken."""
    lines: list[str] = []
    for aside in asides:
        if lines and len(lines[-1]) + len(aside) + 3 <= width:
            lines[-1] += f" · {aside}"
        else:
            lines.append(aside)
    return lines
