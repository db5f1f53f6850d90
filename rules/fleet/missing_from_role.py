"""A robot misses what all others of its role have.

## What it finds
A unit, a kernel parameter or a node that all other robots of a role have. Robots of which no unit, no kernel parameter
or no node is known are not judged; of many robots, up to one in twenty may miss it.

## Why it matters on a robot
The robot was installed before the unit came, or somebody removed it: the watchdog, the log rotation or the driver that
all others have does not run there, and nothing says so.

## Bad
```text
alpha, beta: etc/systemd/system/rover-watchdog.service
gamma:       (none)
```

## Good
```text
alpha, beta, gamma: etc/systemd/system/rover-watchdog.service
```

## When to ignore it
When the robot is meant to be different: give it a role of its own, or declare it in fleet.toml with `[[accept]]`.

## References
- systemd.unit(5), sysctl.d(5)
"""

from collections.abc import Iterator

from bringup_lint.api import NamedTuple
from bringup_lint.api import rule
from bringup_lint.api.fleet import BY_NAME
from bringup_lint.api.fleet import Difference
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import FleetRobot
from bringup_lint.api.fleet import Stated
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import listed
from bringup_lint.api.fleet import missing

_FEWEST = 3
_WHAT = {"unit": "unit", "kernel-parameter": "kernel parameter", "node": "node"}


class Lack(NamedTuple):
    """What the same robots of a role lack."""

    what: list[str]
    holder: Stated
    """One of those who have the first of them."""
    holders: tuple[str, ...]


@rule("warning", silent="no program compares the robots")
def missing_from_role(fleet: Fleet) -> Iterator[FleetFinding]:
    for subject, kind in _WHAT.items():
        saying = {each.robot.number for each in fleet.stated(subject)}
        known = [robot for robot in fleet.robots if robot.number in saying]
        for lacking, lack in _lacks(fleet, subject, known).items():
            what = f"the {kind}{'s' * (len(lack.what) > 1)} {listed(lack.what)}"
            verb = "misses" if len(lacking) == 1 else "miss"
            names = tuple(robot.name for robot in lacking)
            yield fleet_finding(
                [*missing(lacking), lack.holder],
                f"{listed(names)} {verb} {what}, which {len(lack.holders)} of {len(lack.holders) + len(lacking)} robots"
                f" of the role {lacking[0].role} have",
                advice="install it, or declare the difference in fleet.toml: [[accept]]",
                difference=Difference(lack.what[0], "there", lack.holders, "missing", names),
            )


def _lacks(fleet: Fleet, subject: str, known: list[FleetRobot]) -> dict[tuple[FleetRobot, ...], Lack]:
    """What few robots of a role lack, by those who lack it."""
    roles: dict[str, list[FleetRobot]] = {}
    for robot in known:
        roles.setdefault(robot.role, []).append(robot)
    found: dict[tuple[FleetRobot, ...], Lack] = {}
    for by_robot in fleet.by_key(subject, roles.values(), BY_NAME):
        first = next(iter(by_robot.values()))[0]
        robots = roles[first.robot.role]
        lacking = tuple(robot for robot in robots if robot.name not in by_robot)
        if not lacking or len(robots) < _FEWEST or len(lacking) > max(1, len(robots) // 20):
            continue
        found.setdefault(lacking, Lack([], first, tuple(by_robot))).what.append(first.fact.key or first.fact.value)
    return found
