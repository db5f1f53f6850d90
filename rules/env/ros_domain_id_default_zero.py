"""A robot that talks to other machines, on the domain that everybody has.

## What it finds
A process that talks to other machines (by `ROS_STATIC_PEERS`, or peers or a discovery server in its DDS configuration)
with multicast discovery on, and whose whole environment is known to set no `ROS_DOMAIN_ID`, or 0.

## Why it matters on a robot
Domain 0 is everybody's: every ROS 2 machine of the network sees the robot's topics, a second robot's velocity commands
included.

## Bad
```sh
ROS_STATIC_PEERS=10.0.0.20
```

## Good
```sh
ROS_STATIC_PEERS=10.0.0.20
ROS_DOMAIN_ID=17
```

## References
- ROS 2 documentation, "The ROS_DOMAIN_ID"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning")
def ros_domain_id_default_zero(robot: Robot) -> Iterator[Finding]:
    said = set()
    for process in robot.ros.processes:
        environment = process.environment
        domain = environment.get("ROS_DOMAIN_ID")
        free = environment.defines("ROS_DOMAIN_ID") is False or (domain and domain.text in ("0", ""))
        if not free or robot.dds.keeps_to_itself(process) or robot.ros.is_development(process.where):
            continue
        machine = next(iter(robot.dds.machines_of(process)), None)
        where = domain.value if domain else machine
        if machine is None or where.span in said:
            continue
        said.add(where.span)
        yield finding(
            where,
            f"{process.name} talks to {machine} in domain 0, in which every ROS 2 machine of the network is",
            advice="give every robot a ROS_DOMAIN_ID of its own, from 1 to 101",
            related=[note(process.where, "runs in domain 0"), note(machine, "is told of the other machine here")],
        )
