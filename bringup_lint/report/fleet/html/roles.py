"""The roles: how many robots each has, and how far these differ from each other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from bringup_lint.report.fleet.html.entries import found_by
from bringup_lint.report.fleet.html.entries import role_of
from bringup_lint.report.fleet.html.links import Links
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.html.markup import text


def roles(report: FleetReport, links: Links) -> Iterator[str]:
    """A row for each role of each site."""
    odd = {name for found in report.shown if found.difference is not None for name in found.robots}
    counts: dict[str, list[int]] = defaultdict(lambda: [0, 0, 0, 0])
    for robot in report.robots:
        values = (1, robot.name in links.findings, robot.name in odd, len(robot.own))
        counts[role_of(robot)] = [count + value for count, value in zip(counts[role_of(robot)], values)]
    heads = ("role", "robots", "in a finding", "differ", "own findings")
    yield f"<thead><tr>{''.join(f'<th scope=col>{head}</th>' for head in heads)}</tr></thead>"
    for role, row in sorted(counts.items()):
        cells = "".join(f"<td>{count}</td>" for count in row)
        yield f"<tr {found_by(role)}><th scope=row>{text(role)}</th>{cells}</tr>"
