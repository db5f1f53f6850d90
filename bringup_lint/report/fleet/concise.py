"""One line a finding: ``path:line: severity[rule] message``; those of the fleet first, then each robot's own."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.report.columns import plain_start
from bringup_lint.report.columns import printable
from bringup_lint.report.fleet.model import FleetReport


def render(report: FleetReport) -> Iterator[str]:
    return (printable(" ".join(line.split())) + "\n" for line in _lines(report))


def _lines(report: FleetReport) -> Iterator[str]:
    for found in report.shown:
        place = found.places[0]
        yield f"{plain_start(place.path)}:{place.line}: {found.severity}[{found.rule}] {found.message}"
    for robot in report.robots:
        for own in robot.own:
            yield f"{plain_start(own.path)}:{own.line}:{own.column}: {own.severity}[{own.rule}] {own.message}"
