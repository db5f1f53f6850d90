"""The report of a fleet for people: each finding with its robots and differences, then each robot in a line."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from heapq import nsmallest

from bringup_lint.fleet.fleet import Difference
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.fleet import listed
from bringup_lint.fleet.summary import Summary
from bringup_lint.plural import counted
from bringup_lint.plural import of_severity
from bringup_lint.report.columns import plain_starts
from bringup_lint.report.columns import printable
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.paint import Paint
from bringup_lint.report.paint import painter
from bringup_lint.report.wrap import wrap

MOST_PLACES = 5
MOST_NAMES = 8
MOST_ROBOTS = 40
"""Robots that get a line of their own; of a bigger fleet those with the most findings."""

_Row = tuple[Summary, Counter[str]]


def render(report: FleetReport) -> Iterator[str]:
    paint = painter(report.colour)
    width = min(max(report.width, 40), 120)
    for found in report.shown:
        yield plain_starts("\n".join(_block(found, width, paint))) + "\n\n"
    yield plain_starts("\n".join(_robots(report, paint))) + "\n\n"
    yield "\n".join(_summary(report)) + "\n"


def _block(found: FleetFinding, width: int, paint: Paint) -> Iterator[str]:
    style = str(found.severity)
    name = f"{style}[{found.rule}]"
    first, *more = wrap(f"{name}: {printable(' '.join(found.message.split()))}", width - 2)
    yield f"{paint(style, first[: len(name)])}{paint('strong', first[len(name) :])}"
    yield from (f"  {paint('strong', line)}" for line in more)
    for place in found.places[:MOST_PLACES]:
        yield f"  {paint('frame', '-->')} {printable(f'{place.robot}: {place.path}:{place.line}')}"
    if len(found.places) > MOST_PLACES:
        yield f"      and {len(found.places) - MOST_PLACES} more"
    if found.difference is not None:
        yield from _difference(found.difference, paint)
    if found.advice:
        first, *more = wrap(printable(found.advice), width - 10)
        yield f"  {paint('frame', '=')} {paint('strong', 'help:')} {first}"
        yield from (f"          {line}" for line in more)
    yield f"  {paint('frame', '=')} {paint('strong', 'docs:')} bringup-lint explain {found.rule}"


def _difference(difference: Difference, paint: Paint) -> Iterator[str]:
    usual = f"- {difference.usual}  ({len(difference.usual_robots)} robots)"
    odd = f"+ {difference.odd}  ({listed(difference.odd_robots, MOST_NAMES)})"
    yield f"      {paint('strong', printable(difference.key))}"
    yield f"      {paint('faint', printable(usual))}"
    yield f"      {paint('mark', printable(odd))}"


def _robots(report: FleetReport, paint: Paint) -> Iterator[str]:
    """Each robot with its own findings and those of the fleet that name it."""
    concerned = Counter(robot for found in report.shown for robot in found.robots)
    rows: Iterable[_Row] = ((robot, Counter(own.severity for own in robot.own)) for robot in report.robots)

    def order(row: _Row) -> tuple[int, int, str]:
        return (-concerned[row[0].name], -row[1]["error"], row[0].name)

    if len(report.robots) > MOST_ROBOTS:
        rows = nsmallest(MOST_ROBOTS, rows, key=order)
    shown = list(rows)
    size = max((len(robot.name) for robot, _ in shown), default=5)
    yield paint("strong", f"{'robot':{size}}  fleet  errors  warnings  role")
    for robot, own in shown:
        counts = f"{concerned[robot.name]:5}  {own['error']:6}  {own['warning']:8}"
        yield printable(f"{robot.name:{size}}  {counts}  {robot.role}{' at ' + robot.site if robot.site else ''}")
        yield from (f"  {paint('error', 'failed:')} {printable(failure)}" for failure in robot.failures)
    if len(report.robots) > MOST_ROBOTS:
        yield f"and {len(report.robots) - MOST_ROBOTS} more"


def _summary(report: FleetReport) -> Iterator[str]:
    counts = report.counts
    found = ", ".join(of_severity(counts[name], name) for name in ("error", "warning", "info"))
    accepted = sum(bool(each.declared) for each in report.findings)
    own = sum(len(robot.own) for robot in report.robots)
    yield f"Fleet of {counted(len(report.robots), 'robot')}: {found}{f', {accepted} accepted' if accepted else ''}."
    yield f"On single robots: {counted(own, 'finding')}, as bringup-lint ROBOT shows."
    silenced = [f"{number} suppressed by {what}" for what, number in sorted(report.silenced.items())]
    if silenced:
        yield printable(f"On single robots: {', '.join(silenced)}: --no-ignores")
    yield from (f"bringup-lint failed inside: {failure}" for failure in report.failures)
