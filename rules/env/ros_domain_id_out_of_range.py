"""ROS_DOMAIN_ID needs a port above 65535.

## What it finds
A domain above 232. Robots whose DDS configuration changes the port base or the domain gain are not reported.

## Why it matters on a robot
The ports of a domain are computed from its number: no participant can be created, and no node starts. Older
versions of Fast DDS do not even log an error.

## Bad
```sh
ROS_DOMAIN_ID=300
```

## Good
```sh
ROS_DOMAIN_ID=30
```

## When to ignore it
When a DDS configuration that is not in the tree changes the port base or the domain gain.

## References
- RTPS 2.2, section 9.6.2.3: 7400 + 250 x domain
- https://docs.ros.org/en/rolling/Concepts/Intermediate/About-Domain-ID.html
- https://github.com/ros2/rmw_fastrtps/issues/261
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.ros import MAX_DOMAIN
from bringup_lint.api.ros import domain_id
from bringup_lint.api.ros import highest_port


@rule(
    "error",
    symptoms=[
        "domainId is over 232",
        "resulting port number is out of range",
        "failed to create domain",
        "Failed to create unicast sockets for domain * resulting port numbers * are out of range",
        "resulting port number * is out of range",
        "port must be 0-65535",
        "should not be lower than zero",
    ],
)
def ros_domain_id_out_of_range(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("ROS_DOMAIN_ID"):
        number = domain_id(setting.text).number
        if number is not None and number > MAX_DOMAIN and not _own_ports(robot):
            yield finding(
                setting.value,
                f"Domain {number} needs UDP port {highest_port(number)}: no node starts"
                if number < 2**24
                else f"Domain {number} is truncated to 32 bits: the nodes join another domain, or none",
                advice="use a domain from 0 to 101",
            )


def _own_ports(robot: Robot) -> bool:
    """Some DDS file of the tree may move the ports."""
    sources = robot.of_kind("cyclonedds", "fastdds")
    return any(
        word in source.said for source in sources for word in ("DomainGain", "domainIDGain", "portBase", "<Base>")
    )
