"""A robot that talks to other machines uses domain 0.

## What it finds
A process that talks to other machines (through `ROS_STATIC_PEERS`, or peers or a discovery server in its DDS
configuration) with multicast discovery enabled, when its whole environment is known and sets no `ROS_DOMAIN_ID`, or
sets it to 0.

## Why it matters on a robot
Domain 0 is the default of every ROS 2 machine. All of them on the network see the robot's topics and can command
it, including a second robot.

## Bad
```sh
ROS_STATIC_PEERS=10.0.0.20
```

## Good
```sh
ROS_STATIC_PEERS=10.0.0.20
ROS_DOMAIN_ID=17
```

## When to ignore it
When only the robot and its own computers are on the network.

## References
- ROS 2 documentation, "The ROS_DOMAIN_ID"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="domain 0 works; nodes of other robots just appear")
def ros_domain_id_default_zero(robot: Robot) -> Iterator[Finding]:
    said = set()
    for process in robot.ros.processes:
        environment = process.environment
        domain = environment.get("ROS_DOMAIN_ID")
        free = environment.defines("ROS_DOMAIN_ID") is False or (domain and domain.text in ("0", ""))
        if not free or robot.dds.keeps_to_itself(process) or robot.ros.is_development(process.where):
            continue
        machine = next(iter(robot.dds.machines_of(process)), None)
        if machine is None:
            continue
        where = domain.value if domain else machine
        if where.span in said:
            continue
        said.add(where.span)
        yield finding(
            where,
            f"{process.name} talks to {machine} in domain 0, the default of every ROS 2 machine on the network",
            advice="give every robot its own ROS_DOMAIN_ID, from 1 to 101",
            related=[note(process.where, "runs in domain 0"), note(machine, "the other machine is named here")],
        )
