"""The report of a fleet in a format. What cannot be rendered is left out and said, so that it costs nothing else."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Sequence

from bringup_lint.apart import failing
from bringup_lint.dataclass import replace
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.report.fleet import FleetReport
from bringup_lint.report.fleet import render


class _Owned(NamedTuple):
    """A finding of one robot alone."""

    robot: int
    own: Own


class Rendered(NamedTuple):
    text: str
    failures: tuple[str, ...]
    """What could not be rendered."""


def rendered(output_format: str, report: FleetReport) -> Rendered:
    """The report in a format. Findings with which it cannot be rendered are left out; where
    only all of them together fail, those of single robots."""
    try:
        return Rendered(render(output_format, report), ())
    except Exception as error:
        first = error
    what = f"rendering as {output_format}"
    owned = [_Owned(number, own) for number, robot in enumerate(report.robots) for own in robot.own]

    def with_findings(part: Sequence[FleetFinding]) -> str:
        return render(output_format, replace(report, findings=tuple(part), robots=_robots(report, ())))

    def with_owned(part: Sequence[_Owned]) -> str:
        return render(output_format, replace(report, findings=(), robots=_robots(report, part)))

    broken = {id(found): (found.rule, error) for found, error in failing(report.findings, with_findings)}
    broken |= {id(each): (each.own.rule, error) for each, error in failing(owned, with_owned)}
    said = tuple(f"{what} a finding of {rule} failed: {type(error).__name__}" for rule, error in broken.values())
    said = said or (f"{what} failed: {type(first).__name__}",)
    sound = replace(
        report,
        findings=tuple(found for found in report.findings if id(found) not in broken),
        robots=_robots(report, [each for each in owned if id(each) not in broken]),
        failures=(*report.failures, *said),
        exit_code=3,
    )
    if not broken:
        sound = replace(sound, robots=_robots(report, ()))
    return Rendered(render(output_format, sound), said)


def _robots(report: FleetReport, owned: Iterable[_Owned]) -> tuple[Summary, ...]:
    """The robots with these findings of their own alone."""
    by_robot: dict[int, list[Own]] = {}
    for each in owned:
        by_robot.setdefault(each.robot, []).append(each.own)
    return tuple(replace(robot, own=tuple(by_robot.get(number, ()))) for number, robot in enumerate(report.robots))
