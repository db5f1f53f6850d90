"""What the rules of the fleet ask: the summaries of many robots."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from bringup_lint.finding import Confidence
from bringup_lint.finding import Severity
from bringup_lint.fleet.fleet import Difference
from bringup_lint.fleet.fleet import Fleet
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.fleet import FleetPlace
from bringup_lint.fleet.fleet import Majority
from bringup_lint.fleet.fleet import Marked
from bringup_lint.fleet.fleet import Stated
from bringup_lint.fleet.fleet import listed
from bringup_lint.fleet.store import BY_BOTH
from bringup_lint.fleet.store import BY_KEY
from bringup_lint.fleet.store import BY_NAME
from bringup_lint.fleet.store import BY_VALUE
from bringup_lint.fleet.store import FleetRobot
from bringup_lint.fleet.summary import Fact

__all__ = [
    "BY_BOTH",
    "BY_KEY",
    "BY_NAME",
    "BY_VALUE",
    "Difference",
    "Fact",
    "Fleet",
    "FleetFinding",
    "FleetRobot",
    "Majority",
    "Marked",
    "Stated",
    "difference",
    "fleet_finding",
    "listed",
    "missing",
    "names",
]


def fleet_finding(
    places: Iterable[Marked | Stated],
    message: str,
    *,
    advice: str = "",
    difference: Difference | None = None,
    severity: str = "",
    confidence: str = "",
) -> FleetFinding:
    """One defect of several robots; it is shown at the first place. ``severity`` and ``confidence`` are the rule's
    where they are not given."""
    own = Severity[severity.upper()] if severity else None
    sure = Confidence[confidence.upper()] if confidence else None
    return FleetFinding(
        message,
        tuple(FleetPlace(each.robot.name, each[1].path, each[1].line) for each in places),
        advice,
        difference,
        own_severity=own,
        own_confidence=sure,
    )


def names(places: Iterable[Marked | Stated], most: int = 3) -> str:
    """The names of the robots, as a sentence has them."""
    return listed((each.robot.name for each in places), most)


def difference(key: str, usual: list[Stated], odd: list[Stated]) -> Difference:
    """What most robots say and what some say instead, for the report to show side by side."""
    return Difference(
        key,
        usual[0].fact.value,
        _one_object(tuple(each.robot.name for each in usual)),
        odd[0].fact.value,
        _one_object(tuple(each.robot.name for each in odd)),
    )


@lru_cache(maxsize=100)
def _one_object(names: tuple[str, ...]) -> tuple[str, ...]:
    """The same names as one object: those of a thousand robots are in each finding of a role."""
    return names


def missing(robots: Iterable[FleetRobot]) -> list[Stated]:
    """The places of what robots do not have: what was read of them."""
    return [Stated(robot, Fact("missing", "", "", robot.path, 1)) for robot in robots]
