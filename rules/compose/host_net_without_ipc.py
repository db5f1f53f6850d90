"""Containers on the host network do not share memory.

## What it finds
Two or more services that run ROS, by what they or the image that the tree builds start, with `network_mode: host` and
Fast DDS, when one of them has neither `ipc: host` nor a shared `/dev/shm`. Silent if a transport profile or
`FASTDDS_BUILTIN_TRANSPORTS` may disable shared memory, and where the image of a service is not known, because it may
select another middleware. If every service selects Fast DDS explicitly, `fastdds/shm-docker` reports the problem. The
services of one file are one finding.

## Why it matters on a robot
On the host network the containers look like processes of one machine. Fast DDS sends through shared memory that the
other container cannot see: `ros2 topic list` shows everything, `ros2 topic echo` nothing.

## Bad
```yaml
nav:   {image: ros:jazzy, network_mode: host}
slam:  {image: ros:jazzy, network_mode: host}
```

## Good
```yaml
nav:   {image: ros:jazzy, network_mode: host, ipc: host}
slam:  {image: ros:jazzy, network_mode: host, ipc: host}
```

## When to ignore it
When the image itself contains a Fast DDS profile without shared memory.

## References
- https://github.com/eProsima/Fast-DDS/issues/2956, https://github.com/ros2/rmw_fastrtps/issues/812
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import Service

TRANSPORTS = (
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTDDS_BUILTIN_TRANSPORTS",
    "ROS_DISCOVERY_SERVER",
)


@rule(
    "warning",
    confidence="medium",
    silent="discovery succeeds, and Fast DDS does not report the samples that never arrive",
)
def host_net_without_ipc(robot: Robot) -> Iterator[Finding]:
    for file in robot.compose.files:
        services = [s for s in file.services if s.is_whole and s.is_on_host_network and robot.runners.runs_ros2(s)]
        if len(services) < 2 or file.source.template or not all(_is_fast_dds(robot, service) for service in services):
            continue
        if all(robot.compose.variables(service, "RMW_IMPLEMENTATION") for service in services):
            continue
        apart = [service for service in services if not _shares_memory(service)]
        if apart:
            service = apart[0]
            other = next(each for each in services if each is not service)
            yield finding(
                service.place_of("network_mode"),
                f"'{service.name}' shares the network with '{other.name}' but not its memory: no data arrives",
                advice="give all of them ipc: host and the same user, or use a profile without shared memory",
                related=[
                    note(each.place_of("network_mode"), f"'{each.name}' is on the host network too")
                    for each in services
                    if each is not service
                ],
            )


def _is_fast_dds(robot: Robot, service: Service) -> bool:
    if len(robot.compose.env_files(service)) < len(service.env_files):
        return False
    if robot.compose.variables(service, *TRANSPORTS):
        return False
    rmw = robot.compose.variables(service, "RMW_IMPLEMENTATION")
    if rmw:
        return all("fastrtps" in value for _, value in rmw)
    runner = robot.runners.of_service(service)
    return runner is not None and runner.environment.defines("RMW_IMPLEMENTATION") is False


def _shares_memory(service: Service) -> bool:
    ipc = service.scalar("ipc")
    shared = any(volume.target == "/dev/shm" for volume in service.volumes)
    return shared or (ipc is not None and ipc not in ("private", "none"))
