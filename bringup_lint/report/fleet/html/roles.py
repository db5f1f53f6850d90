"""The roles: how many robots each has, and how far these differ from each other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from html import escape

from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet.html.entries import found_by
from bringup_lint.report.fleet.html.entries import role_of
from bringup_lint.report.fleet.model import FleetReport


def roles(report: FleetReport) -> Iterator[str]:
    """A row for each role of each site."""
    members: dict[str, list[Summary]] = defaultdict(list)
    for robot in report.robots:
        members[role_of(robot)].append(robot)
    named = {name for found in report.shown for name in found.robots}
    odd = {name for found in report.shown if found.difference is not None for name in found.robots}
    heads = ("role", "robots", "in a finding", "differ", "own findings")
    yield f"<thead><tr>{''.join(f'<th scope=col>{head}</th>' for head in heads)}</tr></thead>"
    for role, robots in sorted(members.items()):
        names = {robot.name for robot in robots}
        counts = (len(robots), len(names & named), len(names & odd), sum(len(robot.own) for robot in robots))
        cells = "".join(f"<td>{count}</td>" for count in counts)
        yield f"<tr {found_by(role)}><th scope=row>{escape(role)}</th>{cells}</tr>"
