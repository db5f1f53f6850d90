"""Permissions do not include ros_discovery_info.

## What it finds
A grant to an enclave that does not allow both publishing and subscribing to `ros_discovery_info`. Nothing is
reported if the tree selects Zenoh as its middleware.

## Why it matters on a robot
The RMW creates this topic in every process before the first node. If it is denied, no node of the enclave can
be created.

## Bad
```xml
<topic>rt/odom</topic>
```

## Good
```xml
<topic>ros_discovery_info</topic>
<topic>rt/odom</topic>
```

## When to ignore it
If the enclave belongs to a DDS program that does not use ROS 2.

## References
- rmw_dds_common; https://github.com/ros2/sros2/issues/242
- Cyclone DDS 0.10.5 with security, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.sros2 import matches


@rule("error", symptoms=["Not Allowed By Security"])
def permissions_missing_discovery_info(robot: Robot) -> Iterator[Finding]:
    if any("zenoh" in setting.value for setting in robot.ros.of("RMW_IMPLEMENTATION")):
        return
    for _, grant in robot.sros2.ros_grants:
        if grant.default == "ALLOW" or not grant.allowed:
            continue
        lacks = [
            way
            for way, topics in (
                ("publish", [topic for each in grant.allowed for topic in each.publish]),
                ("subscribe to", [topic for each in grant.allowed for topic in each.subscribe]),
            )
            if not any(matches("ros_discovery_info", topic) for topic in topics)
        ]
        if lacks:
            yield finding(
                grant.place,
                f"{grant.enclave} cannot {' or '.join(lacks)} ros_discovery_info, which every process needs: none "
                "of its nodes can be created",
                advice="add ros_discovery_info to publish and subscribe, and sign the document again",
            )
