"""JUnit's XML, as Jenkins, GitLab and colcon read it: a suite for each file, a failed case for each finding.

The elements are those of the schema of Ant's JUnit task.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import groupby
from xml.sax.saxutils import escape
from xml.sax.saxutils import quoteattr

from bringup_lint.finding import Finding
from bringup_lint.finding.place import inside
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.report.columns import printable
from bringup_lint.report.model import Report
from bringup_lint.report.times import utc
from bringup_lint.report.unicode import sound

_TOOL = "bringup-lint"


class Case(NamedTuple):
    """A test case, and what became of it: ``failure``, ``error``, ``skipped``, or empty when it passed."""

    outcome: str
    text: str


def render(report: Report) -> str:
    return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', "<testsuites>", *_suites(report), "</testsuites>", ""])


def _suites(report: Report) -> Iterator[str]:
    at = utc(report.started or 0)[:19]
    yield from _suite(0, _TOOL, list(_run(report)), at, "\n".join(map(printable, report.by_configuration)))
    findings = sorted(report.findings, key=_file)
    for number, (name, group) in enumerate(groupby(findings, key=_file), 1):
        yield from _suite(number, name, [_case(finding) for finding in group], at)


def _file(finding: Finding) -> str:
    return finding.source.name


def _suite(number: int, name: str, cases: list[Case], at: str, said: str = "") -> Iterator[str]:
    counts = Counter(case.outcome for case in cases)
    yield (
        f"  <testsuite id={_quoted(str(number))} package={_quoted(_TOOL)} name={_quoted(name)} timestamp={_quoted(at)}"
        f' hostname="localhost" tests="{len(cases)}" failures="{counts["failure"]}" errors="{counts["error"]}"'
        f' skipped="{counts["skipped"]}" time="0">'
    )
    yield "    <properties/>"
    yield from (case.text for case in cases)
    yield f"    <system-out>{escape(str(sound(said)))}</system-out>" if said else "    <system-out/>"
    yield "    <system-err/>"
    yield "  </testsuite>"


def _run(report: Report) -> Iterator[Case]:
    """The run itself, which passes when nothing failed inside: a report without cases counts as a broken one."""
    failures = [told for told in report.notifications if told.level == "error"]
    for told in failures:
        yield _in_case(told.rule or "run", _TOOL, "error", "internal", told.message)
    if not failures:
        yield Case("", f'    <testcase name="run" classname="{_TOOL}" time="0"/>')


def _case(finding: Finding) -> Case:
    line, column = finding.source.position(inside(finding.span).start)
    name = f"{finding.rule} {line}:{column}"
    if finding.suppression:
        return _in_case(name, finding.source.name, "skipped", "", finding.suppression.reason)
    told = "\n".join(map(_shown, _details(finding)))
    return _in_case(name, finding.source.name, "failure", str(finding.severity), finding.message, told)


def _in_case(name: str, of: str, outcome: str, kind: str, message: str, told: str = "") -> Case:
    what = f" type={_quoted(kind)}" if kind else ""
    inner = f"<{outcome}{what} message={_quoted(message)}>{escape(told)}</{outcome}>"
    return Case(outcome, f'    <testcase name={_quoted(name)} classname={_quoted(of)} time="0">{inner}</testcase>')


def _details(finding: Finding) -> Iterator[str]:
    """No line begins with a name of the tree: runners take some beginnings for commands."""
    yield f"{finding.severity}[{finding.rule}] at {finding.source.name}:{inside(finding.span).line}: {finding.message}"
    for related in finding.related:
        yield f"see {related.span.path}:{inside(related.span).line}: {related.message}"
    if finding.advice:
        yield f"help: {finding.advice}"


def _shown(text: str) -> str:
    """The text without what XML cannot hold."""
    return str(sound(printable(" ".join(text.split()))))


def _quoted(text: str) -> str:
    return quoteattr(_shown(text))
