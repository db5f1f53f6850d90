"""Robots that must hear each other differ in their middleware.

## What it finds
Another `RMW_IMPLEMENTATION`, mode of security or range of discovery than most robots have, in a site of which
fleet.toml says `domains = "shared"`.

## Why it matters on a robot
Different middlewares find each other at best in part: topics arrive, services hang. A node with security never sees one
without. A robot that is confined to localhost is alone.

## Bad
```sh
# alpha, beta
RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
# gamma
RMW_IMPLEMENTATION=rmw_fastrtps_cpp
```

## Good
```sh
# alpha, beta, gamma
RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
```

## When to ignore it
When the robots speak to each other by other means than ROS 2.

## References
- [Different ROS 2 middleware vendors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Different-Middleware-Vendors.html)
- [ROS 2 security](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Security.html)
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import difference
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("error")
def different_middleware(fleet: Fleet) -> Iterator[FleetFinding]:
    for subject in ("middleware", "security", "discovery"):
        for key, found in fleet.majorities(subject, fleet.talking(), mixed=True):
            for value, odd in found.others.items():
                yield fleet_finding(
                    [*odd, found.usual[0]],
                    f"{names(odd)} {'has' if len(odd) == 1 else 'have'} {key}={value}, and the other robots of the"
                    f" site {found.usual[0].fact.value}: they do not hear each other, or only in part",
                    advice="set one value in one file that all robots get",
                    difference=difference(key, found.usual, odd),
                )
