"""A robot has another DDS domain than it should.

## What it finds
A `ROS_DOMAIN_ID` that differs from the `domain` of the robot in fleet.toml, or from that of the other robots of a
site of which fleet.toml says `domains = "shared"`.

## Why it matters on a robot
Nodes of different domains never find each other, and nothing is logged: the robot is up, and the fleet manager waits
for it forever.

## Bad
```toml
# fleet.toml; beta has ROS_DOMAIN_ID=6
[[robot]]
name = "beta"
root = "beta"
domain = 5
```

## Good
```toml
# fleet.toml; beta has ROS_DOMAIN_ID=5
[[robot]]
name = "beta"
root = "beta"
domain = 5
```

## When to ignore it
When a bridge of domains (domain_bridge) connects the robot.

## References
- [The ROS_DOMAIN_ID](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Domain-ID.html)
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import Stated
from bringup_lint.api.fleet import difference
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("error", silent="participants of different domains do not see each other, and neither side reports it")
def different_domain(fleet: Fleet) -> Iterator[FleetFinding]:
    for robot in fleet.robots:
        domain = robot.one("domain")
        if domain is not None and robot.domain is not None and domain.value != str(robot.domain):
            yield fleet_finding(
                [Stated(robot, domain)],
                f"{robot.name} has the domain {domain.value}, and the inventory says {robot.domain}: nothing that is"
                " meant for it reaches it",
                advice=f"set ROS_DOMAIN_ID={robot.domain}, or change the inventory",
            )
    undeclared = [[robot for robot in robots if robot.domain is None] for robots in fleet.talking()]
    for _, found in fleet.majorities("domain", undeclared):
        for value, odd in found.others.items():
            usual = found.usual[0].fact.value
            yield fleet_finding(
                [*odd, found.usual[0]],
                f"{names(odd)} {'has' if len(odd) == 1 else 'have'} the domain {value}, and the other robots of the"
                f" site {usual}: they never find each other",
                advice=f"set ROS_DOMAIN_ID={usual}",
                difference=difference("ROS_DOMAIN_ID", found.usual, odd),
            )
