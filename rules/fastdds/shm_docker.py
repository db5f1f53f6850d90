"""Containers on the host's network that cannot reach each other's shared memory.

## What it finds
ROS services of one compose file with `network_mode: host`, the same domain and Fast DDS with its default transports,
that do not share their IPC namespace: neither `ipc: host` for all, nor `shareable` and `service:...`, nor one
`/dev/shm`.

## Why it matters on a robot
By the host's network they take each other for processes of one machine and send data through shared memory, which each
container has for itself: topics are listed, and no data arrives.

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

FASTDDS = ("rmw_fastrtps_cpp", "rmw_fastrtps_dynamic_cpp")
OTHERWISE = (
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTDDS_BUILTIN_TRANSPORTS",
    "ROS_DISCOVERY_SERVER",
)


@rule("warning", confidence="medium", symptoms=["topics are listed but no data arrives"])
def shm_docker(robot: Robot) -> Iterator[Finding]:
    files: dict[str, dict[tuple, list]] = {}
    for process in robot.ros.processes if robot.of_kind("compose") else ():
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
                    f"{others[0].name} and {first.name} are on one network, each with shared memory of its own: topics "
                    "are listed, and no data arrives",
                    advice="add ipc: host to both, or give both a UDP-only profile",
                    related=[note(each.name, "a namespace of its own") for each in (first, *others[1:])],
                )


def _shares_by_default(process):
    """Whether it surely runs Fast DDS on the host's network, as far as its environment tells."""
    environment, service = process.environment, process.service
    if not service.is_on_host_network or any(name in environment for name in OTHERWISE):
        return False
    if any(str(volume.target).rstrip("/") in ("/dev/shm", "/dev") for volume in service.volumes):
        return False
    return environment.text("RMW_IMPLEMENTATION") in FASTDDS


def _space(service):
    """The IPC namespace: one name for all that share it."""
    ipc = service.scalar("ipc")
    if ipc is None or ipc == "private":
        return str(service.name)
    if ipc.startswith("service:"):
        return str(ipc).partition(":")[2]
    return str(service.name) if ipc == "shareable" else str(ipc)
