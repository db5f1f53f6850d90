"""Containers on the host's network cannot access each other's shared memory.

## What it finds
ROS services of one compose file with `network_mode: host`, the same domain and Fast DDS with its default
transports, that do not share an IPC namespace. They share one with `ipc: host` in all of them, with
`shareable` and `service:...`, or with a common `/dev/shm`.

## Why it matters on a robot
On the host's network they take each other for processes of the same machine and send data through shared
memory. But each container has its own: topics are listed, and no data arrives.

## Bad
```yaml
base:   {image: lawn, network_mode: host}
camera: {image: lawn, network_mode: host}
```

## Good
```yaml
base:   {image: lawn, network_mode: host, ipc: host}
camera: {image: lawn, network_mode: host, ipc: host}
```

## When to ignore it
If the services do not exchange topics, or each image sets a UDP-only profile that is not visible in the
compose file.

## References
- https://github.com/eProsima/Fast-DDS/issues/2956
- https://github.com/ros2/rmw_fastrtps/issues/812
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.environment import RosProcess

FASTDDS = ("rmw_fastrtps_cpp", "rmw_fastrtps_dynamic_cpp")
OTHERWISE = (
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTDDS_BUILTIN_TRANSPORTS",
    "ROS_DISCOVERY_SERVER",
)


@rule("warning", confidence="medium", symptoms=["topics are listed but no data arrives"])
def shm_docker(robot: Robot) -> Iterator[Finding]:
    if not robot.of_kind("compose"):
        return
    files: dict[str, dict[tuple[str, bool], list[Service]]] = {}
    for process in robot.ros.processes:
        if process.service is not None and process.launcher is None and _shares_by_default(process):
            key = (process.environment.text("ROS_DOMAIN_ID") or "0", "ROS_DOMAIN_ID" in process.environment)
            files.setdefault(process.source.name, {}).setdefault(key, []).append(process.service)
    for groups in files.values():
        for services in groups.values():
            spaces = {_space(service): service for service in reversed(services)}
            if len(spaces) > 1:
                first, *others = sorted(spaces.values(), key=lambda service: service.name.span.start)
                yield finding(
                    others[0].name,
                    f"{others[0].name} and {first.name} are on one network, but do not share memory: topics "
                    "are listed, but no data arrives",
                    advice="add ipc: host to both, or give both a UDP-only profile",
                    related=[note(each.name, "has its own IPC namespace") for each in (first, *others[1:])],
                )


def _shares_by_default(process: RosProcess) -> bool:
    """Whether it surely runs Fast DDS on the host's network, as far as its environment shows."""
    environment, service = process.environment, process.service
    if service is None or not service.is_on_host_network or any(name in environment for name in OTHERWISE):
        return False
    if any(str(volume.target).rstrip("/") in ("/dev/shm", "/dev") for volume in service.volumes):
        return False
    return environment.text("RMW_IMPLEMENTATION") in FASTDDS


def _space(service: Service) -> str:
    """The IPC namespace: one name for all that share it."""
    ipc = service.scalar("ipc")
    if ipc is None or ipc == "private":
        return str(service.name)
    if ipc.startswith("service:"):
        return str(ipc).partition(":")[2]
    return str(service.name) if ipc == "shareable" else str(ipc)
