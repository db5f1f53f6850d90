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

from bringup_lint.api import rule
from bringup_lint.api.fleet import Difference
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import Stated
from bringup_lint.api.fleet import Summary
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import listed
from bringup_lint.api.fleet import missing

_FEWEST = 3
_WHAT = {"unit": "unit", "kernel-parameter": "kernel parameter", "node": "node"}


@rule("warning")
def missing_from_role(fleet: Fleet) -> Iterator[FleetFinding]:
    for role, members in fleet.roles.items():
        for subject in _WHAT:
            robots = [robot for robot in members if any(True for _ in robot.of(subject))]
            for lacking, holders in _missing(subject, fleet, robots):
                names = [each[0].fact.key or each[0].fact.value for each in holders]
                what = f"the {_WHAT[subject]}{'s' * (len(names) > 1)} {listed(names)}"
                verb = "misses" if len(lacking) == 1 else "miss"
                who = listed(robot.name for robot in lacking)
                usual = tuple(each.robot.name for each in holders[0])
                yield fleet_finding(
                    [*missing(lacking), holders[0][0]],
                    f"{who} {verb} {what}, which {len(usual)} of {len(robots)} robots of the role {role} have",
                    advice="install it, or declare the difference in fleet.toml: [[accept]]",
                    difference=Difference(names[0], "there", usual, "missing", tuple(robot.name for robot in lacking)),
                )


def _missing(subject: str, fleet: Fleet, robots: list[Summary]) -> Iterator[tuple[list[Summary], list[list[Stated]]]]:
    """The robots that lack something, with all that just these lack, and who has it."""
    found: dict[str, dict[str, Stated]] = {}
    for each in fleet.stated(subject, robots):
        found.setdefault(each.fact.key or each.fact.value, {}).setdefault(each.robot.name, each)
    together: dict[tuple[str, ...], list[list[Stated]]] = {}
    for _, by_robot in sorted(found.items()):
        lacking = tuple(robot.name for robot in robots if robot.name not in by_robot)
        if lacking and len(robots) >= _FEWEST and len(lacking) <= max(1, len(robots) // 20):
            together.setdefault(lacking, []).append(list(by_robot.values()))
    for names, holders in together.items():
        yield [robot for robot in robots if robot.name in names], holders
