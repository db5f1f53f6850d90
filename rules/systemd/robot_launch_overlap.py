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

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.supervision import Overlap
from bringup_lint.api.supervision import Umbrella
from bringup_lint.api.supervision import launches_of
from bringup_lint.api.supervision import overlaps
from bringup_lint.api.supervision import umbrellas


@rule("warning", symptoms=["Be aware that are nodes in the graph that share an exact name"])
def robot_launch_overlap(robot: Robot) -> Iterator[Finding]:
    for group in robot.units.enabled_ros_groups:
        launches = launches_of(group, robot.units)
        told = set()
        for overlap in overlaps(launches, robot.units, robot.launch):
            told.add(overlap.second.ros.where.span)
            yield _twice(overlap)
        rest = [each for each in launches if each.ros.where.span not in told]
        for umbrella in umbrellas(rest, robot.units, robot.launch):
            yield _beside_layers(umbrella)


def _twice(overlap: Overlap) -> Finding:
    (unit, ros), (other, second), include = overlap
    if include is not None:
        return finding(
            second.where,
            f"{unit.name} already starts {second.where}: with both services, each of its nodes runs twice",
            advice="enable one of the two, or replace the service for the whole robot with a target",
            related=[note(ros.where, f"{unit.name} launches this file"), note(include, "which includes it")],
        )
    return finding(
        second.where,
        f"{unit.name} and {other.name} both launch {second.where}: each of its nodes runs twice",
        advice="enable one of the two",
        related=[note(ros.where, f"{unit.name} also launches it")],
    )


def _beside_layers(umbrella: Umbrella) -> Finding:
    unit, ros = umbrella.whole
    names = ", ".join(layer.unit.name for layer in umbrella.layers)
    return finding(
        ros.where,
        f"{unit.name} seems to launch the whole robot, and {names} its layers: together, every node runs twice",
        advice="enable one set, or replace the service for the whole robot with a target",
        related=[note(layer.ros.where, f"{layer.unit.name} launches a layer") for layer in umbrella.layers],
        confidence="medium",
    )
