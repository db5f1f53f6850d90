"""Two services start the same launch file.

## What it finds
Two ROS services that start at boot together, in one of these cases:

- Both launch the same file with the same arguments.
- The launch file of one includes the launch file of the other.
- The launch files are not in the tree, one service launches the whole robot by its name
  (`bringup.launch.py`), and two or more launch layers of the same package (`drivers.launch.py`). This has
  medium confidence.

Services that exclude each other (`Conflicts=`) and conditional includes are exempt.

## Why it matters on a robot
A service for the whole robot and a service for each layer are both enabled: every node runs twice. Two
drivers compete for one serial port, two controllers publish to one topic, and two nodes with one name answer
in turn.

## Bad
```ini
# rover-bringup.service launches bringup.launch.py, which includes drivers.launch.py
# rover-drivers.service launches drivers.launch.py
# both:
[Install]
WantedBy=multi-user.target
```

## Good
```ini
# rover-bringup.service
[Unit]
Conflicts=rover-drivers.service
```

## When to ignore it
When only one of the services is ever enabled on a robot, for example because provisioning chooses it.

## References
- ROS 2 documentation, "Managing large projects": one top-level launch file
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Ros
from bringup_lint.api.systemd import Unit

WHOLE = re.compile(r"(?:\w+_)?(?:bringup|robot|full|all|system|stack|main)(?:\.launch)?\.(?:py|xml|ya?ml)$")
LAYER = re.compile(
    r"(?:\w+_)?(?:drivers?|hardware|sensors?|perception|localization|slam|mapping|nav2?|navigation|application|planning)"
    r"(?:\.launch)?\.(?:py|xml|ya?ml)$"
)


@rule("warning", symptoms=["Be aware that are nodes in the graph that share an exact name"])
def robot_launch_overlap(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for stack in units.stacks:
        started = [(unit, ros) for unit in stack for process in units.started(unit) for _, ros in process.launches]
        told = set()
        for at, (unit, ros) in enumerate(started):
            for other, second in started[:at] + started[at + 1 :]:
                if other is unit or units.conflict(unit, other) or second.where.span in told:
                    continue
                include = included(robot, ros, second)
                if include is not None or (same(ros, second) and stack.index(unit) < stack.index(other)):
                    told.add(second.where.span)
                if include is not None:
                    yield finding(
                        second.where,
                        f"{unit.name} already starts {second.where}: with both services, each of its nodes runs twice",
                        advice="enable one of the two, or replace the service for the whole robot with a target",
                        related=[
                            note(ros.where, f"{unit.name} launches this file"),
                            note(include, "which includes it"),
                        ],
                    )
                elif second.where.span in told:
                    yield finding(
                        second.where,
                        f"{unit.name} and {other.name} both launch {second.where}: each of its nodes runs twice",
                        advice="enable one of the two",
                        related=[note(ros.where, f"{unit.name} also launches it")],
                    )

        yield from _umbrella(robot, stack, [(unit, ros) for unit, ros in started if ros.where.span not in told])


def _umbrella(robot: Robot, stack: list[Unit], started: list[tuple[Unit, Ros]]) -> Iterator[Finding]:
    """A service for the whole robot and services for its layers, by the names of launch files of one package."""
    units = robot.units
    for unit, ros in started:
        if not ros.package or not WHOLE.match(ros.where) or robot.launch.named(ros.package, ros.target):
            continue
        others = [
            (other, second)
            for other, second in started
            if second.package == ros.package and LAYER.match(second.where) and not units.conflict(unit, other)
        ]
        if len(others) > 1:
            names = ", ".join(other.name for other, _ in others)
            yield finding(
                ros.where,
                f"{unit.name} seems to launch the whole robot, and {names} its layers: together, every node runs twice",
                advice="enable one set, or replace the service for the whole robot with a target",
                related=[note(second.where, f"{other.name} launches a layer") for other, second in others],
                confidence="medium",
            )


def same(one: Ros, other):
    return one.target == other.target and one.package == other.package and set(one.arguments) == set(other.arguments)


def included(robot: Robot, outer: Ros, inner):
    """The unconditional include by which the launch file of one command leads to that of the other."""
    entry = robot.launch.named(outer.package, outer.target)
    wanted = robot.launch.named(inner.package, inner.target)
    if entry is None or wanted is None or entry is wanted or outer.arguments or inner.arguments:
        return None
    for include in robot.launch.expansion(entry).includes:
        if include.target is wanted and not include.conditions:
            return include.action.span
    return None
