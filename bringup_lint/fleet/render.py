"""The report of a fleet in a format. What cannot be rendered is left out and said, so that it costs nothing else."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from collections.abc import Sequence
from itertools import islice
from typing import IO
from typing import cast

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import replace
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.report.fleet import FleetReport
from bringup_lint.report.fleet import render
from bringup_lint.report.fleet.model import Robots
from bringup_lint.steps import failing

MOST_IN_MEMORY = 1024 * 1024
"""Bytes of a report that is longer on its way through a file without a name."""


class Rendered(NamedTuple):
    text: IO[str]
    """Whole, to be read from its beginning."""
    failures: tuple[str, ...]
    """What could not be rendered."""

    @property
    def pieces(self) -> Iterator[str]:
        self.text.seek(0)
        return iter(lambda: self.text.read(MOST_IN_MEMORY), "")


def rendered(output_format: str, report: FleetReport) -> Rendered:
    """The report in a format. Findings with which it cannot be rendered are left out; where only all of them together
    fail, those of single robots. Raises OSError when there is no room for it."""
    try:
        return Rendered(_whole(output_format, report), ())
    except OSError:
        raise
    except Exception as error:
        first = error
    what = f"rendering as {output_format}"
    robots = range(len(report.robots))

    def with_findings(part: Sequence[FleetFinding]) -> None:
        _whole(output_format, replace(report, findings=tuple(part), robots=_Without(report.robots, lambda *_: False)))

    def with_robots(part: Sequence[int]) -> None:
        named = set(part)
        _whole(output_format, replace(report, findings=(), robots=_Without(report.robots, lambda at, _: at in named)))

    broken = {id(found): (found.rule, error) for found, error in failing(report.findings, with_findings)}
    owned = {at: _broken_of(output_format, report, at) for at, _ in failing(robots, with_robots)}
    found = [*broken.values(), *(each for of_robot in owned.values() for each in of_robot.values())]
    said = tuple(f"{what} a finding of {rule} failed: {type(error).__name__}" for rule, error in found)
    sound = replace(
        report,
        findings=tuple(found for found in report.findings if id(found) not in broken),
        robots=_Without(report.robots, lambda at, own: bool(said) and own not in owned.get(at, ())),
        failures=(*report.failures, *(said or (f"{what} failed: {type(first).__name__}",))),
        exit_code=3,
    )
    return Rendered(_whole(output_format, sound), sound.failures[len(report.failures) :])


def _broken_of(output_format: str, report: FleetReport, number: int) -> dict[Own, tuple[str, Exception]]:
    """The findings of one robot alone with which it cannot be rendered."""
    robot = next(islice(report.robots, number, None))

    def with_own(part: Sequence[Own]) -> None:
        _whole(output_format, replace(report, findings=(), robots=(replace(robot, own=tuple(part)),)))

    return {own: (own.rule, error) for own, error in failing(robot.own, with_own)}


def _whole(output_format: str, report: FleetReport) -> IO[str]:
    """Everything in a file without a name, so that what fails on the way is not half written."""
    from tempfile import SpooledTemporaryFile

    file = SpooledTemporaryFile(MOST_IN_MEMORY, "w+", encoding="utf-8", errors="surrogatepass", newline="")  # noqa: SIM115
    try:
        for piece in render(output_format, report):
            file.write(piece)
    except BaseException:
        file.close()
        raise
    return cast("IO[str]", file)


@dataclass(frozen=True)
class _Without:
    """Robots without some of their own findings."""

    robots: Robots
    stays: Callable[[int, Own], bool]
    """Asked with the number of the robot."""

    def __len__(self) -> int:
        return len(self.robots)

    def __iter__(self) -> Iterator[Summary]:
        for at, robot in enumerate(self.robots):
            yield replace(robot, own=tuple(own for own in robot.own if self.stays(at, own)))
