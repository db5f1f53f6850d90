"""Fleet: the summaries of all robots, as the rules of the fleet ask them, and what these rules find."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from itertools import groupby
from typing import TypeVar

from bringup_lint.dataclass import dataclass
from bringup_lint.finding import Confidence
from bringup_lint.finding import Severity
from bringup_lint.fleet.store import BY_BOTH
from bringup_lint.fleet.store import BY_KEY
from bringup_lint.fleet.store import By
from bringup_lint.fleet.store import FleetRobot
from bringup_lint.fleet.store import Store
from bringup_lint.fleet.summary import Fact
from bringup_lint.fleet.summary import Mark
from bringup_lint.named_tuple import NamedTuple

T = TypeVar("T")
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

    robot: FleetRobot
    fact: Fact


class Majority(NamedTuple):
    """What most robots of a group say of one key, and what the others say."""

    usual: list[Stated]
    others: dict[str, list[Stated]]
    """By value."""


class Marked(NamedTuple):
    """A mark with the robot that has it."""

    robot: FleetRobot
    mark: Mark


_OfRobot = TypeVar("_OfRobot", Stated, Marked)


@dataclass(frozen=True, eq=False)
class Fleet:
    """What the rules of the fleet ask: the robots with what their summaries say of the network, names and keys."""

    store: Store

    @property
    def robots(self) -> list[FleetRobot]:
        """In the order of their names."""
        return self.store.robots

    @cached_property
    def sites(self) -> dict[str, list[FleetRobot]]:
        return _grouped(self.robots, lambda robot: robot.site)

    @cached_property
    def roles(self) -> dict[str, list[FleetRobot]]:
        return _grouped(self.robots, lambda robot: robot.role)

    def shared(self, *kinds: str) -> Iterator[list[Marked]]:
        """The key material of these kinds that several robots have, one entry a robot."""
        rows = groupby(self.store.shared(*kinds), key=lambda row: (row[1].kind, row[1].digest))
        return (list(_first_of_each(Marked(self.robots[at], mark) for at, mark in group)) for _, group in rows)

    def stated(self, subject: str) -> Iterator[Stated]:
        """What robots say of a subject."""
        return (Stated(self.robots[at], fact) for at, fact in self.store.facts(subject))

    def alike(self, subject: str, by: By = BY_BOTH) -> Iterator[list[Stated]]:
        """What several robots say alike, by key and value or by one of them, one entry a robot."""
        for _, group in self._together(subject, by):
            found = list(_first_of_each(group))
            if len(found) > 1:
                yield found

    def same(self, subject: str) -> Iterator[list[Stated]]:
        """What several robots of one site say alike, one entry a robot."""
        for group in self.alike(subject):
            by_site = _grouped(group, lambda stated: stated.robot.site)
            yield from (found for found in by_site.values() if len(found) > 1)

    def talking(self) -> Iterator[list[FleetRobot]]:
        """The robots of each site that the inventory wants to hear each other."""
        for robots in self.sites.values():
            if len(robots) > 1 and all(robot.talks == "shared" for robot in robots):
                yield robots

    def by_key(
        self, subject: str, teams: Iterable[Iterable[FleetRobot]], by: By = BY_KEY
    ) -> Iterator[dict[str, list[Stated]]]:
        """For each key of a subject and each team that says something of it: what its robots say, by their names. No
        robot is in two teams."""
        team_of = {robot.number: at for at, team in enumerate(teams) for robot in team}
        for _, group in self._together(subject, by):
            found: dict[int, dict[str, list[Stated]]] = defaultdict(lambda: defaultdict(list))
            for stated in group:
                team = team_of.get(stated.robot.number)
                if team is not None:
                    found[team][stated.robot.name].append(stated)
            yield from (found[team] for team in sorted(found))

    def majorities(
        self, subject: str, teams: Iterable[Iterable[FleetRobot]], *, mixed: bool = False
    ) -> Iterator[tuple[str, Majority]]:
        """Each key of a subject of which most robots of a team, at least two thirds, say the same, and some do not.
        Robots that say several things are left out, or differ by each of them where ``mixed`` is set."""
        for by_robot in self.by_key(subject, teams):
            said: list[Stated] = []
            several: list[Stated] = []
            for each in by_robot.values():
                if len({self._plain(one) for one in each}) > 1:
                    several += each
                else:
                    said.append(each[0])
            found = self._majority(said, several if mixed else [])
            if found is not None:
                yield found.usual[0].fact.key, found

    def _together(self, subject: str, by: By) -> Iterator[tuple[object, Iterator[Stated]]]:
        """What robots say, those together that are alike in ``by``."""
        stated = (Stated(self.robots[at], fact) for at, fact in self.store.facts(subject, by))
        return groupby(stated, key=lambda each: by.of(each.fact))

    def _majority(self, said: list[Stated], mixed: list[Stated]) -> Majority | None:
        values: dict[str, list[Stated]] = defaultdict(list)
        for each in said:
            values[self._plain(each)].append(each)
        plain, usual = max(values.items(), key=lambda pair: len(pair[1]), default=("", []))
        robots = len(said) + len({each.robot.number for each in mixed})
        if robots < FEWEST or 3 * len(usual) < 2 * robots:
            return None
        del values[plain]
        for each in mixed:
            value = self._plain(each)
            if value != plain:
                values[value].append(each)
        others = [list(_first_of_each(group)) for group in values.values()]
        return Majority(usual, {group[0].fact.value: group for group in others}) if others else None

    def _plain(self, stated: Stated) -> str:
        """A value in which the robot does not name itself, so that it can be the same on all of them."""
        value = stated.fact.value
        for name in (stated.robot.name, self._host_names.get(stated.robot.number, "")):
            if len(name) >= SHORTEST_NAME:
                value = value.replace(name, "\0")
        return value

    @cached_property
    def _host_names(self) -> dict[int, str]:
        """By number, of the robots that have one."""
        found: dict[int, set[str]] = defaultdict(set)
        for at, fact in self.store.facts("host-name"):
            found[at].add(fact.value)
        return {at: min(names) for at, names in found.items() if len(names) == 1}


def _first_of_each(found: Iterable[_OfRobot]) -> Iterator[_OfRobot]:
    """One entry a robot. What a robot says lies together."""
    last = -1
    for each in found:
        if each.robot.number != last:
            last = each.robot.number
            yield each


def _grouped(items: Iterable[T], key: Callable[[T], str]) -> dict[str, list[T]]:
    groups: dict[str, list[T]] = defaultdict(list)
    for item in items:
        groups[key(item)].append(item)
    return dict(sorted(groups.items()))


def listed(names: Iterable[str], most: int = 3) -> str:
    """``a, b, c and 4 more``."""
    names = list(dict.fromkeys(names))
    shown = ", ".join(names[:most])
    if len(names) > most:
        return f"{shown} and {len(names) - most} more"
    return shown if len(names) < 2 else f"{', '.join(names[:-1])} and {names[-1]}"
