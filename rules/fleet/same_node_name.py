"""Nodes of several robots in one domain have the same name.

## What it finds
Nodes of robots of one site and one `ROS_DOMAIN_ID` that have the same full name, and run whenever the robots are up.

## Why it matters on a robot
Services and parameters of the name are answered by either robot, lifecycle managers switch the node of the other robot,
and topics without a namespace mix.

## Bad
```python
# alpha and beta
Node(package="rover_base", executable="base", name="base")
```

## Good
```python
# alpha; beta has namespace="beta"
Node(package="rover_base", executable="base", name="base", namespace="alpha")
```

## When to ignore it
When something that the files do not show keeps the robots apart, such as a network for each.

## References
- `ros2 node list` warns of nodes that share an exact name
- [Nodes](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Nodes.html)
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import Stated
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import listed
from bringup_lint.api.fleet import names

_ALONE = {"1", "LOCALHOST", "OFF"}
"""Values of ROS_LOCALHOST_ONLY and ROS_AUTOMATIC_DISCOVERY_RANGE that keep a robot for itself."""


@rule("error", confidence="medium", symptoms=["nodes in the graph that share an exact name"])
def same_node_name(fleet: Fleet) -> Iterator[FleetFinding]:
    together: dict[tuple[str, ...], tuple[list[Stated], list[str]]] = {}
    for group in _meeting(fleet):
        robots = tuple(each.robot.name for each in group)
        together.setdefault(robots, (group, []))[1].append(group[0].fact.value)
    for group, nodes in together.values():
        yield fleet_finding(
            group,
            f"{len(group)} robots of one domain start {listed(nodes)}: {names(group)}; services and parameters are"
            " answered by either",
            advice="start the nodes of each robot in a namespace of its own, or give it its own domain",
        )


def _meeting(fleet: Fleet) -> Iterator[list[Stated]]:
    """The nodes of one name that find each other."""
    domains = dict(_domains(fleet))
    for group in fleet.alike("node"):
        by_place: dict[tuple[str, str], list[Stated]] = {}
        for each in group:
            if each.robot.number in domains:
                by_place.setdefault((each.robot.site, domains[each.robot.number]), []).append(each)
        yield from (found for found in by_place.values() if len(found) > 1)


def _domains(fleet: Fleet) -> Iterator[tuple[int, str]]:
    """The domain of each robot that others of its site hear, by its number."""
    for robot in fleet.robots:
        domain = robot.one("domain")
        confined = any(fact.value in _ALONE for fact in robot.of("discovery"))
        if domain is not None and not confined and robot.talks != "separate":
            yield robot.number, domain.value
