"""Robots that must hear each other differ in their middleware.

## What it finds
In a site of which fleet.toml says `domains = "shared"`:
- another `RMW_IMPLEMENTATION`, mode of security or range of discovery than most robots have
- DDS settings of a robot, from its Cyclone DDS configuration, Fast DDS profile or variables, with which it surely hears
  none of the others, as a warning: another domain tag, no transport in common, a discovery server where the others
  discover by multicast, another port of that multicast, or no way out of the robot: the loopback interface alone, or
  neither multicast nor a peer on another machine

Ports are compared where no peers are listed. `fleet/drift` compares what keeps nobody apart, such as sizes of buffers.

## Why it matters on a robot
Different middlewares find each other at best in part: topics arrive, services hang. A node with security never sees one
without. A robot that is confined to localhost is alone. Nothing is logged of a robot that is not heard.

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
- DDSI-RTPS 2.5, 9.6.2.3: the ports of discovery
- Cyclone DDS, configuration guide, `Discovery/Tag`, `Discovery/Ports`
- Fast DDS, "Discovery Server", "RTPSParticipantQos"
- [ROS 2 security](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Security.html)
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import Stated
from bringup_lint.api.fleet import difference
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("error", silent="robots with different middleware do not see each other, and neither side reports it")
def different_middleware(fleet: Fleet) -> Iterator[FleetFinding]:
    yield from _variables(fleet)
    for key, found in fleet.majorities("dds", fleet.talking()):
        for group in found.others.values():
            odd = [each for each in group if _never_meet(key, found.usual[0], each)]
            if odd:
                yield fleet_finding(
                    [*odd, found.usual[0]],
                    f"{names(odd)} {'differs' if len(odd) == 1 else 'differ'} from the other robots of the site in the"
                    f" {key}, {odd[0].fact.value} in place of {found.usual[0].fact.value}: they do not hear each other",
                    advice="set it alike in one DDS configuration that all robots get",
                    difference=difference(key, found.usual, odd),
                    severity="warning",
                )


def _variables(fleet: Fleet) -> Iterator[FleetFinding]:
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


def _never_meet(key: str, usual: Stated, odd: Stated) -> bool:
    """Whether two robots that differ in a DDS setting surely do not hear each other."""
    one, other = usual.fact.value, odd.fact.value
    if key == "transport":
        return set(one.split()).isdisjoint(other.split())
    if key == "way of discovery":
        return one == "multicast"
    return key != "discovery port" or _ports_differ(one, other, odd)


def _ports_differ(one: str, other: str, robot: Stated) -> bool:
    """Whether they do in the domain of the robot; where it is not known, in every domain."""
    (base, gain), (other_base, other_gain) = _port(one), _port(other)
    domain = robot.robot.one("domain")
    if domain is None:
        return gain == other_gain
    return base + gain * int(domain.value) != other_base + other_gain * int(domain.value)


def _port(value: str) -> tuple[int, int]:
    """The base and the gain of a port, which a robot states as ``7400 + 250 × domain``."""
    base, _, gain = value.removesuffix(" × domain").partition(" + ")
    return int(base), int(gain)
