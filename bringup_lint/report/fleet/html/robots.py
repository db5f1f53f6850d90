"""Each robot by itself: what failed, and which rules found what where."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.plural import counted
from bringup_lint.report.fleet.html.entries import found_by
from bringup_lint.report.fleet.html.entries import words_of
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.html.markup import text

MOST_RULES = 12
"""Rules that are listed of one robot, the most severe first."""
_SEVERITIES = ("error", "warning", "info")


def robots(report: FleetReport) -> Iterator[str]:
    silent = 0
    for number, robot in enumerate(report.robots):
        if robot.own or robot.silenced or robot.failures:
            yield _robot(number, robot)
        else:
            silent += 1
    if silent:
        yield f"<p>Nothing was found on {silent} {'of them' if silent < len(report.robots) else 'robots'}.</p>"


def _robot(number: int, robot: Summary) -> str:
    failures = "".join(f"<p><b class=error>failed</b> {text(failure)}</p>" for failure in robot.failures)
    said = f"{counted(len(robot.own), 'finding')} in {counted(robot.files, 'file')}"
    said += "".join(f", {number} suppressed by {what}" for what, number in robot.silenced)
    return (
        f"<details id=r{number} {found_by(words_of(robot))}{' open' * bool(failures)}>"
        f"<summary><b>{text(robot.name)}</b> {text(said)} <code>{text(robot.path)}</code></summary>"
        f"{failures}{_own(robot.own)}</details>"
    )


def _own(own: tuple[Own, ...]) -> str:
    by_rule: dict[tuple[int, str], list[Own]] = defaultdict(list)
    for finding in own:
        by_rule[_SEVERITIES.index(finding.severity), finding.rule].append(finding)
    rows = [_rule(by_rule[key]) for key in sorted(by_rule)]
    more = len(rows) - MOST_RULES
    if more > 0:
        rows[MOST_RULES:] = [f"<li>and {more} more rules</li>"]
    return f"<ul>{''.join(rows)}</ul>"


def _rule(found: list[Own]) -> str:
    first = found[0]
    more = f", and {len(found) - 1} more" if len(found) > 1 else ""
    return (
        f"<li><b class={first.severity}>{first.severity}</b> <code>{text(first.rule)}</code> "
        f"{text(first.message)} <code>{text(f'{first.path}:{first.line}')}</code>{more}</li>"
    )
