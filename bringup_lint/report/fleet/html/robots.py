"""Each robot by itself: what failed, and which rules found what where."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.plural import counted
from bringup_lint.report.fleet.html.entries import found_by
from bringup_lint.report.fleet.html.entries import role_of
from bringup_lint.report.fleet.html.entries import words_of
from bringup_lint.report.fleet.html.links import Links
from bringup_lint.report.fleet.html.links import rule_link
from bringup_lint.report.fleet.html.severities import ORDER
from bringup_lint.report.fleet.html.severities import badge
from bringup_lint.report.fleet.html.severities import badges
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.html.markup import text

MOST_RULES = 12
"""Rules that are listed of one robot, the most severe first."""
MOST_FINDINGS = 12
"""Of the fleet, listed for one robot."""


def robots(report: FleetReport, links: Links) -> Iterator[str]:
    silent = 0
    for number, robot in enumerate(report.robots):
        if links.has_entry(robot):
            yield _robot(number, robot, report, links)
        else:
            silent += 1
    if silent:
        which = "of them" if silent < len(report.robots) else "robots"
        yield f"<p class=small>Nothing was found on {silent} {which}.</p>"


def _robot(number: int, robot: Summary, report: FleetReport, links: Links) -> str:
    failures = "".join(f"<p><b class=error>failed</b> {text(failure)}</p>" for failure in robot.failures)
    said = f"{counted(len(robot.own), 'finding')} in {counted(robot.files, 'file')}"
    said += "".join(f", {number} suppressed by {what}" for what, number in robot.silenced)
    return (
        f"<details class=entry id=r{number} {found_by(words_of(robot))}{' open' * bool(failures)}>"
        f"<summary><b>{text(robot.name)}</b> <span class=small>{text(role_of(robot))}</span> "
        f"{badges(finding.severity for finding in robot.own)} "
        f"<span class=small>{text(said)} <code class=place>{text(robot.path)}</code></span></summary>"
        f"{failures}{_of_the_fleet(links.findings.get(robot.name, []))}{_own(robot.own, report)}</details>"
    )


def _of_the_fleet(found: list[tuple[int, FleetFinding]]) -> str:
    if not found:
        return ""
    rows = [
        f"<li>{badge(str(each.severity))} <a href=#f{number}>{text(each.rule)}</a> {text(each.message)}</li>"
        for number, each in found[:MOST_FINDINGS]
    ]
    more = len(found) - MOST_FINDINGS
    return f"<h3>With others</h3><ul>{''.join(rows)}{f'<li>and {more} more</li>' if more > 0 else ''}</ul>"


def _own(own: tuple[Own, ...], report: FleetReport) -> str:
    by_rule: dict[tuple[int, str], list[Own]] = defaultdict(list)
    for finding in own:
        by_rule[ORDER.index(finding.severity), finding.rule].append(finding)
    rows = [_rule(by_rule[key], report) for key in sorted(by_rule)]
    more = len(rows) - MOST_RULES
    if more > 0:
        rows[MOST_RULES:] = [f"<li>and {more} more rules</li>"]
    return f"<h3>By itself</h3><ul>{''.join(rows)}</ul>" if rows else ""


def _rule(found: list[Own], report: FleetReport) -> str:
    first = found[0]
    more = f", and {len(found) - 1} more" if len(found) > 1 else ""
    return (
        f"<li>{badge(first.severity)} {rule_link(first.rule, report.rules.get(first.rule))} "
        f"{text(first.message)} <code class=place>{text(f'{first.path}:{first.line}')}</code>{more}</li>"
    )
