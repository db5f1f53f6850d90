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
    found: dict[tuple[str, str, str], list[Stated]] = {}
    for robot in fleet.robots:
        domain = robot.one("domain")
        confined = any(fact.value in _ALONE for fact in robot.of("discovery"))
        if domain is None or confined or robot.talks == "separate":
            continue
        for node in {fact.value: fact for fact in robot.of("node")}.values():
            found.setdefault((robot.site, domain.value, node.value), []).append(Stated(robot, node))
    together: dict[tuple[str, ...], list[list[Stated]]] = {}
    for group in found.values():
        if len(group) > 1:
            together.setdefault(tuple(each.robot.name for each in group), []).append(group)
    for groups in together.values():
        yield fleet_finding(
            groups[0],
            f"{len(groups[0])} robots of one domain start {listed(group[0].fact.value for group in groups)}:"
            f" {names(groups[0])}; services and parameters are answered by either",
            advice="start the nodes of each robot in a namespace of its own, or give it its own domain",
        )
