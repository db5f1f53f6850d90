"""ROS_DOMAIN_ID uses ports of the ephemeral range.

## What it finds
A domain from 102 to 214: its ports are in Linux's ephemeral range. Robots that move the range or reserve the ports
by sysctl are not reported.

## Why it matters on a robot
Any outgoing connection may occupy a port that DDS needs. From time to time a node fails at start with "Address
already in use", and nothing is visible afterwards.

## Bad
```sh
ROS_DOMAIN_ID=150
```

## Good
```sh
ROS_DOMAIN_ID=50
```

## When to ignore it
When the image moves the range or reserves the ports in a place that is not in the tree.

## References
- https://docs.ros.org/en/rolling/Concepts/Intermediate/About-Domain-ID.html
- ip-sysctl: net.ipv4.ip_local_port_range is 32768 to 60999
- https://github.com/selfpatch/ros2_medkit/issues/595
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.ros import EPHEMERAL_DOMAINS
from bringup_lint.api.ros import domain_id


@rule("warning", symptoms=["failed to create participant"])
def ros_domain_id_ephemeral(robot: Robot) -> Iterator[Finding]:
    if any(_moves_ports(source.text) for source in robot.of_kind("sysctl")):
        return
    for setting in robot.ros.of("ROS_DOMAIN_ID"):
        number = domain_id(setting.text).number
        if number is not None and number in EPHEMERAL_DOMAINS:
            yield finding(
                setting.value,
                f"Domain {number} uses ports from {7400 + 250 * number} on, which outgoing connections may take first:"
                " nodes fail at random",
                advice="use a domain from 0 to 101, or reserve the ports with net.ipv4.ip_local_reserved_ports",
            )


def _moves_ports(text: str) -> bool:
    return "ip_local_port_range" in text or "ip_local_reserved_ports" in text
