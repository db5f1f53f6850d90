"""Nothing limits what a ROS service may consume.

## What it finds
A ROS service that has no MemoryMax=, MemoryHigh= or CPUQuota=, and whose slice has none either. One-shot
services and containers are exempt.

## Why it matters on a robot
A node with a memory leak takes all memory. The kernel then kills a process of its own choice: the driver,
sshd, the logger.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover slam.launch.py'
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover slam.launch.py'
MemoryHigh=1800M
MemoryMax=2G
CPUQuota=300%
```

## When to ignore it
When systemd-oomd or a cgroup outside of this tree limits the service, or when throttling it would be unsafe,
as for a control loop.

## References
- systemd.resource-control(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit

LIMITS = ("MemoryMax", "MemoryHigh", "MemoryLimit", "CPUQuota")


@rule("info", symptoms=["Out of memory: Killed process", "A process of this unit has been killed by the OOM killer"])
def no_resource_limits(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        if not unit.complete or unit.get("Type") == "oneshot" or service.in_container:
            continue
        if any(unit.get(key, "Service") for key in LIMITS) or _limited_slice(robot, unit):
            continue
        yield finding(
            unit.where,
            f"{unit.name} may use all memory and every CPU: one node with a leak brings down the whole robot",
            advice="set MemoryHigh=, MemoryMax= and CPUQuota=",
        )


def _limited_slice(robot: Robot, unit: Unit) -> bool:
    """Whether the slice has a limit, or is unknown."""
    name = unit.get("Slice", "Service")
    found = robot.units.find(name, unit) if name else None
    return bool(name) and (found is None or any(found.get(key, "Slice") for key in LIMITS))
