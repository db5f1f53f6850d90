"""Discovery is limited to this machine, and the configuration lists other machines.

## What it finds
`ROS_LOCALHOST_ONLY=1`, or `ROS_AUTOMATIC_DISCOVERY_RANGE=OFF`, in the environment of a process whose DDS configuration
lists peers or a discovery server on another machine. The range LOCALHOST only switches multicast off: listed peers are
contacted all the same, and it is not reported. Cyclone DDS files that name an interface of their own overrule the
variable. Files and units for development and simulation are left alone.

## Why it matters on a robot
Up to Humble the variable closes all interfaces but the loopback one, and OFF gives the process a discovery of its own:
the other machine never sees the robot, and nothing in the log says so. Newer distributions treat
`ROS_LOCALHOST_ONLY=1` as a wish not to be found: one of the two is not meant.

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

## References
- rcl, localhost.c and discovery_options.c; rmw_cyclonedds and rmw_fastrtps, how they set up a participant
- https://github.com/turtlebot/turtlebot4_simulator/issues/89
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least

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
        sure = limit.name == RANGE or newer is False
        consequence = "that machine never sees the robot" if sure else "one of the two is not meant"
        yield finding(
            limit.value,
            f"{process.name} may only talk to this machine, but its DDS configuration lists {machine}: {consequence}",
            advice=f"delete {limit.name}, or the other machines",
            related=[note(machine, "the other machine is listed here"), note(process.where, "gets the variable")],
            severity=None if sure else "warning",
        )


def _names_interface(robot, process):
    """Whether a Cyclone DDS file overrules the variable."""
    places = ("General/Interfaces/NetworkInterface", "General/NetworkInterfaceAddress")
    return any(domain.found(place) for domain in robot.dds.domains_of(process) for place in places)


def _limit(environment, newer):
    """The setting that keeps discovery on this machine."""
    if newer is not False and environment.text(RANGE) == "OFF":
        return environment.get(RANGE)
    return environment.get("ROS_LOCALHOST_ONLY") if environment.text("ROS_LOCALHOST_ONLY") == "1" else None
