"""Containers on the host's network cannot access each other's shared memory.

## What it finds
ROS services of one compose file with `network_mode: host`, the same domain and Fast DDS with its default
transports, that do not share an IPC namespace. They share one with `ipc: host` in all of them, with
`shareable` and `service:...`, or with a common `/dev/shm`. Also a service whose profile or `FASTDDS_BUILTIN_TRANSPORTS`
leaves nothing but shared memory, without the `ipc: host` that another service of the file has.

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
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import Runner
from bringup_lint.api.environment import RosProcess

FASTDDS = ("rmw_fastrtps_cpp", "rmw_fastrtps_dynamic_cpp")
OTHERWISE = (
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTDDS_BUILTIN_TRANSPORTS",
    "ROS_DISCOVERY_SERVER",
)

SHARED = regex(r"<type>[ \t]*SHM[ \t]*</type>")
ALONE = regex(r"<useBuiltinTransports>[ \t]*false")
BY_NAME = regex(r"(?i)/shm[-_]?only[^/]*$")
ELSEWHERE = regex(r"<type>[ \t]*(?:UDP|TCP)v[46][ \t]*</type>")


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
    yield from _only_in_memory(robot)


def _only_in_memory(robot: Robot) -> Iterator[Finding]:
    """Services that send through shared memory alone, and not the one of the host, which another service has."""
    for runner in robot.runners.in_containers:
        service = runner.service
        if service is None or _space(service) != str(service.name) or _shares_folder(service):
            continue
        on_host = next((each for each in _beside(robot, service) if each.scalar("ipc") == "host"), None)
        only = _memory_alone(runner) if on_host is not None else None
        if on_host is not None and only is not None:
            yield finding(
                service.name,
                f"{service.name} sends through shared memory alone, and not through that of {on_host.name}: nothing "
                "of it leaves the container",
                advice="add ipc: host",
                related=[note(only, "no other transport"), note(on_host.name, "shares the memory of the host")],
            )


def _beside(robot: Robot, service: Service) -> Iterator[Service]:
    return (each for each in robot.compose.services if each.source is service.source and each is not service)


def _memory_alone(runner: Runner) -> Located | None:
    """What says that a container has no other transport."""
    environment = runner.environment
    built_in = environment.get("FASTDDS_BUILTIN_TRANSPORTS")
    if built_in is not None and built_in.text == "SHM":
        return built_in.value
    for name in OTHERWISE[:2]:
        variable = environment.get(name)
        path = variable.text if variable is not None else None
        if variable is None or path is None:
            continue
        file = runner.reads(path)
        if file is None and BY_NAME.search(path):
            return variable.value
        if file is not None and file.says(SHARED) and file.says(ALONE) and not file.says(ELSEWHERE):
            return variable.value
    return None


def _shares_by_default(process: RosProcess) -> bool:
    """Whether it surely runs Fast DDS on the host's network, as far as its environment shows."""
    environment, service = process.environment, process.service
    if service is None or not service.is_on_host_network or any(name in environment for name in OTHERWISE):
        return False
    if _shares_folder(service):
        return False
    return environment.text("RMW_IMPLEMENTATION") in FASTDDS


def _shares_folder(service: Service) -> bool:
    return any(str(volume.target).rstrip("/") in ("/dev/shm", "/dev") for volume in service.volumes)


def _space(service: Service) -> str:
    """The IPC namespace: one name for all that share it."""
    ipc = service.scalar("ipc")
    if ipc is None or ipc == "private":
        return str(service.name)
    if ipc.startswith("service:"):
        return str(ipc).partition(":")[2]
    return str(service.name) if ipc == "shareable" else str(ipc)
