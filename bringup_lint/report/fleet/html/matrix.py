"""Robots against the rules of the fleet: a letter where a rule names a robot, which leads to the finding.

The robots that a finding of the fleet names come first.
"""

from __future__ import annotations

from collections import Counter
from collections import defaultdict
from collections.abc import Iterator

from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet.html.entries import found_by
from bringup_lint.report.fleet.html.entries import role_of
from bringup_lint.report.fleet.html.entries import words_of
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.html.markup import text

_SIGNS = {"error": "E", "warning": "W", "info": "I"}
_Cells = dict[str, tuple[int, FleetFinding]]
"""The first finding of each rule, with its number."""


def matrix(report: FleetReport) -> Iterator[str]:
    cells: dict[str, _Cells] = defaultdict(dict)
    for number, found in enumerate(report.shown):
        for name in found.robots:
            cells[name].setdefault(found.rule, (number, found))
    rules = sorted({found.rule for found in report.shown})
    heads = "".join(f"<th scope=col><span>{text(rule.partition('/')[2])}</span></th>" for rule in rules)
    yield "<thead><tr><th scope=col>robot</th><th scope=col>role</th><th scope=col>by itself</th>"
    yield heads + "</tr></thead>"
    for named in (True, False):
        for number, robot in enumerate(report.robots):
            if (robot.name in cells) is named:
                yield _row(number, robot, cells.get(robot.name, {}), rules)


def _row(number: int, robot: Summary, cells: _Cells, rules: list[str]) -> str:
    row = "".join(_cell(cells.get(rule)) for rule in rules)
    return (
        f"<tr {found_by(words_of(robot), *cells)}><th scope=row>{text(robot.name)}</th>"
        f"<td>{text(role_of(robot))}</td><td>{_by_itself(number, robot)}</td>{row}</tr>"
    )


def _cell(entry: tuple[int, FleetFinding] | None) -> str:
    if entry is None:
        return "<td></td>"
    number, found = entry
    sign, title = _SIGNS[str(found.severity)], text(found.rule)
    return f'<td class={found.severity}><a href="#f{number}" title="{title}">{sign}</a></td>'


def _by_itself(number: int, robot: Summary) -> str:
    counts = Counter(finding.severity for finding in robot.own)
    said = [f"{counts[severity]} {sign}" for severity, sign in _SIGNS.items() if counts[severity]]
    if robot.failures:
        said.append("failed")
    return f'<a href="#r{number}">{" ".join(said)}</a>' if said else ""
