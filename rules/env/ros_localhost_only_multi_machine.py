"""Discovery is limited to this machine, but the configuration lists other machines.

## What it finds
`ROS_LOCALHOST_ONLY=1` or `ROS_AUTOMATIC_DISCOVERY_RANGE=OFF` in the environment of a process whose DDS
configuration lists peers or a discovery server on another machine. The range LOCALHOST is info: it only disables
multicast, and listed peers are contacted all the same. Not reported: Cyclone DDS files that select an interface and so
override the variable, and files and units for development and simulation.

## Why it matters on a robot
Up to Humble the variable closes all interfaces but loopback, and OFF separates the discovery of the process. The
other machine never sees the robot, and nothing in the log says so. On newer distributions `ROS_LOCALHOST_ONLY=1`
only limits discovery, so the finding is a warning: one of the two settings is wrong.

## Bad
```sh
ROS_LOCALHOST_ONLY=1
CYCLONEDDS_URI=file:///etc/lawn/cyclonedds.xml   # <Peer Address="10.0.0.20"/>
```

## Good
```sh
ROS_LOCALHOST_ONLY=0
CYCLONEDDS_URI=file:///etc/lawn/cyclonedds.xml
```

## When to ignore it
When the peers are a leftover for another machine and this process must stay local. Deleting them is better.

## References
- rcl, localhost.c and discovery_options.c; rmw_cyclonedds and rmw_fastrtps, how they set up a participant
- https://github.com/turtlebot/turtlebot4_simulator/issues/89
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.environment import RosProcess
from bringup_lint.api.ros import at_least
from bringup_lint.api.systemd import Environment
from bringup_lint.api.systemd import Variable

RANGE = "ROS_AUTOMATIC_DISCOVERY_RANGE"


@rule("error", symptoms=["no topics from the other machine", "ros2 topic list is empty"])
def ros_localhost_only_multi_machine(robot: Robot) -> Iterator[Finding]:
    newer = at_least(robot.target.ros, "iron")
    for process in robot.ros.processes:
        limit = _limit(process.environment, newer)
        if limit is None or robot.ros.is_development(limit.value) or robot.ros.is_development(process.where):
            continue
        machine = next(iter(robot.dds.other_machines(process)), None)
        if machine is None or (limit.name != RANGE and _names_interface(robot, process)):
            continue
        if limit.text == "LOCALHOST":
            yield _contacted(process, limit, machine)
            continue
        sure = limit.name == RANGE or newer is False
        consequence = "that machine never sees the robot" if sure else "one of the two settings is wrong"
        yield finding(
            limit.value,
            f"{process.name} may talk only to this machine, but its DDS configuration lists {machine}: {consequence}",
            advice=f"delete {limit.name}, or the other machines",
            related=[note(machine, "the other machine is listed here"), note(process.where, "gets the variable")],
            severity=None if sure else "warning",
        )


def _contacted(process: RosProcess, limit: Variable, machine: Located) -> Finding:
    return finding(
        limit.value,
        f"{process.name} contacts {machine} all the same: the range LOCALHOST keeps no listed peer away",
        advice="delete the peer if the process is to stay on this machine",
        related=[note(machine, "the other machine is listed here"), note(process.where, "gets the variable")],
        severity="info",
    )


def _names_interface(robot: Robot, process: RosProcess) -> bool:
    """Whether a Cyclone DDS file overrules the variable."""
    places = ("General/Interfaces/NetworkInterface", "General/NetworkInterfaceAddress")
    return any(domain.found(place) for domain in robot.dds.domains_of(process) for place in places)


def _limit(environment: Environment, newer: bool | None) -> Variable | None:
    """The setting that keeps discovery on this machine."""
    if newer is not False and environment.text(RANGE) in ("OFF", "LOCALHOST"):
        return environment.get(RANGE)
    return environment.get("ROS_LOCALHOST_ONLY") if environment.text("ROS_LOCALHOST_ONLY") == "1" else None
