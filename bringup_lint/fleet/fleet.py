"""Fleet: the summaries of all robots, as the rules of the fleet ask them, and what these rules find."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.finding import Confidence
from bringup_lint.finding import Severity
from bringup_lint.fleet.summary import Fact
from bringup_lint.fleet.summary import Mark
from bringup_lint.fleet.summary import Summary
from bringup_lint.named_tuple import NamedTuple

FEWEST = 3
"""Robots of which a majority says anything."""
SHORTEST_NAME = 3
"""Characters of a robot's name by which it is recognized in a value."""


class FleetPlace(NamedTuple):
    """A line of a file of one robot. Line 1 is the first."""

    robot: str
    path: str
    line: int


class Difference(NamedTuple):
    """What some robots of a role say where the others say something else."""

    key: str
    usual: str
    usual_robots: tuple[str, ...]
    odd: str
    odd_robots: tuple[str, ...]


@dataclass(frozen=True)
class FleetFinding:
    """One defect of several robots together. The rule fills in the message and the places, the run the rest."""

    message: str
    places: tuple[FleetPlace, ...]
    """The first one is where it is shown."""
    advice: str = ""
    difference: Difference | None = None
    severity: Severity = Severity.WARNING
    confidence: Confidence = Confidence.HIGH
    rule: str = ""
    own_severity: Severity | None = None
    """What the rule says of this one finding; None where it is as severe as the rule."""
    own_confidence: Confidence | None = None
    declared: str = ""
    """Why the inventory accepts it; empty when it does not."""

    @property
    def robots(self) -> tuple[str, ...]:
        """Those that are to be changed."""
        if self.difference is not None:
            return self.difference.odd_robots
        return tuple(dict.fromkeys(place.robot for place in self.places))


class Stated(NamedTuple):
    """A fact with the robot that states it."""

    robot: Summary
    fact: Fact


class Majority(NamedTuple):
    """What most robots of a group say of one key, and what the others say."""

    usual: list[Stated]
    others: dict[str, list[Stated]]
    """By value."""


class Marked(NamedTuple):
    """A mark with the robot that has it."""

    robot: Summary
    mark: Mark


@dataclass(frozen=True)
class Fleet:
    robots: tuple[Summary, ...]
    """In the order of their names."""

    @cached_property
    def sites(self) -> dict[str, list[Summary]]:
        return _grouped(self.robots, lambda robot: robot.site)

    @cached_property
    def roles(self) -> dict[str, list[Summary]]:
        return _grouped(self.robots, lambda robot: robot.role)

    def shared(self, *kinds: str) -> Iterator[list[Marked]]:
        """The key material of these kinds that several robots have, one entry a robot."""
        found: dict[tuple[str, str], dict[str, Marked]] = defaultdict(dict)
        for robot in self.robots:
            for mark in robot.marks:
                if mark.kind in kinds:
                    found[mark.kind, mark.digest].setdefault(robot.name, Marked(robot, mark))
        return (list(group.values()) for group in found.values() if len(group) > 1)

    def stated(self, subject: str, robots: Iterable[Summary] | None = None) -> list[Stated]:
        """What robots say of a subject."""
        asked = self.robots if robots is None else robots
        return [Stated(robot, fact) for robot in asked for fact in robot.of(subject)]

    def same(self, subject: str) -> Iterator[list[Stated]]:
        """What several robots of one site say alike, one entry a robot."""
        for robots in self.sites.values():
            found: dict[tuple[str, str], dict[str, Stated]] = defaultdict(dict)
            for stated in self.stated(subject, robots):
                found[stated.fact.key, stated.fact.value].setdefault(stated.robot.name, stated)
            yield from (list(group.values()) for group in found.values() if len(group) > 1)

    def talking(self) -> Iterator[list[Summary]]:
        """The robots of each site that the inventory wants to hear each other."""
        for robots in self.sites.values():
            if len(robots) > 1 and all(robot.talks == "shared" for robot in robots):
                yield robots

    def majorities(self, subject: str, robots: Iterable[Summary]) -> Iterator[tuple[str, Majority]]:
        """Each key of a subject of which most of these robots, at least two thirds, say the same, and some do not."""
        by_key: dict[str, dict[str, list[Stated]]] = defaultdict(lambda: defaultdict(list))
        for stated in self.stated(subject, robots):
            by_key[stated.fact.key][stated.robot.name].append(stated)
        for key, by_robot in sorted(by_key.items()):
            found = _majority([said[0] for said in by_robot.values() if len({_plain(each) for each in said}) == 1])
            if found is not None:
                yield key, found


def _majority(said: list[Stated]) -> Majority | None:
    values: dict[str, list[Stated]] = defaultdict(list)
    for each in said:
        values[_plain(each)].append(each)
    usual = max(values.values(), key=len, default=[])
    if len(values) < 2 or len(said) < FEWEST or 3 * len(usual) < 2 * len(said):
        return None
    others = (group for group in values.values() if group is not usual)
    return Majority(usual, {group[0].fact.value: group for group in others})


def _plain(stated: Stated) -> str:
    """A value in which the robot does not name itself, so that it can be the same on all of them."""
    value = stated.fact.value
    own = stated.robot.one("host-name")
    for name in (stated.robot.name, own.value if own else ""):
        if len(name) >= SHORTEST_NAME:
            value = value.replace(name, "\0")
    return value


def _grouped(robots: Iterable[Summary], key: Callable[[Summary], str]) -> dict[str, list[Summary]]:
    groups: dict[str, list[Summary]] = defaultdict(list)
    for robot in robots:
        groups[key(robot)].append(robot)
    return dict(sorted(groups.items()))


def listed(names: Iterable[str], most: int = 3) -> str:
    """``a, b, c and 4 more``."""
    names = list(dict.fromkeys(names))
    shown = ", ".join(names[:most])
    if len(names) > most:
        return f"{shown} and {len(names) - most} more"
    return shown if len(names) < 2 else f"{', '.join(names[:-1])} and {names[-1]}"
