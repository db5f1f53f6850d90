"""The robots: what was found on each, by severity, and a letter where a rule of the fleet names it, which leads to the
finding.

The robots that a finding of the fleet names come first.
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet.html.entries import found_by
from bringup_lint.report.fleet.html.entries import role_of
from bringup_lint.report.fleet.html.entries import words_of
from bringup_lint.report.fleet.html.links import Links
from bringup_lint.report.fleet.html.severities import badges
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.html.markup import text

_SIGNS = {"error": "E", "warning": "W", "info": "I"}


def matrix(report: FleetReport, links: Links) -> Iterator[str]:
    rules = sorted({found.rule for found in report.shown})
    heads = "".join(f"<th scope=col class=rule><span>{text(rule.partition('/')[2])}</span></th>" for rule in rules)
    yield "<thead><tr><th scope=col>robot</th><th scope=col>role</th><th scope=col>of the fleet</th>"
    yield f"<th scope=col>by itself</th>{heads}</tr></thead>"
    for named in (True, False):
        for number, robot in enumerate(report.robots):
            if (robot.name in links.findings) is named:
                yield _row(number, robot, links, rules)


def _row(number: int, robot: Summary, links: Links, rules: list[str]) -> str:
    found = links.findings.get(robot.name, [])
    first = {each.rule: (at, each) for at, each in reversed(found)}
    name = text(robot.name)
    head = f'<a href="#r{number}">{name}</a>' if links.has_entry(robot) else name
    return (
        f"<tr {found_by(words_of(robot), *first)}><th scope=row>{head}</th><td>{text(role_of(robot))}</td>"
        f"<td>{badges(str(each.severity) for _, each in found)}</td><td>{_by_itself(number, robot)}</td>"
        f"{''.join(_cell(first.get(rule)) for rule in rules)}</tr>"
    )


def _cell(entry: tuple[int, FleetFinding] | None) -> str:
    if entry is None:
        return "<td></td>"
    number, found = entry
    sign, title = _SIGNS[str(found.severity)], text(found.rule)
    return f'<td class="sign {found.severity}"><a href="#f{number}" title="{title}">{sign}</a></td>'


def _by_itself(number: int, robot: Summary) -> str:
    said = badges(finding.severity for finding in robot.own) + "<b class=error>failed</b>" * bool(robot.failures)
    return f'<a href="#r{number}">{said}</a>' if said else ""
