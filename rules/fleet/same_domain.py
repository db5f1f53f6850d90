"""Robots that must not hear each other share a DDS domain.

## What it finds
Robots of a site of which fleet.toml says `domains = "separate"`, and that have the same `ROS_DOMAIN_ID`.

## Why it matters on a robot
All nodes of a domain on one network find each other. `/cmd_vel` of one robot drives the other, `/tf` of both mix, and
services are answered by whoever is faster.

## Bad
```toml
# fleet.toml; alpha and beta have ROS_DOMAIN_ID=5
[site.hall]
domains = "separate"
```

## Good
```toml
# fleet.toml; alpha has ROS_DOMAIN_ID=5, beta 6
[site.hall]
domains = "separate"
```

## When to ignore it
When every topic of each robot lies in its own namespace: say `domains = "shared"`.

## References
- [The ROS_DOMAIN_ID](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Domain-ID.html)
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import Stated
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("error", silent="discovery works; nodes of the other robot just appear")
def same_domain(fleet: Fleet) -> Iterator[FleetFinding]:
    for robots in fleet.sites.values():
        found: dict[str, list[Stated]] = {}
        for robot in robots:
            domain = robot.one("domain")
            if domain is not None and robot.talks == "separate":
                found.setdefault(domain.value, []).append(Stated(robot, domain))
        for domain_id, group in found.items():
            if len(group) > 1:
                yield fleet_finding(
                    group,
                    f"{len(group)} robots that must not hear each other have the domain {domain_id}: {names(group)};"
                    " commands for one move the other",
                    advice="give each robot its own ROS_DOMAIN_ID, from 0 to 101",
                )
