"""The size of the shared memory of a service that has none of its own.

## What it finds
`shm_size` of a service with `ipc: host`, `ipc: service:NAME` or `ipc: container:NAME`; an info where the service
chooses Cyclone DDS, which needs none.

## Why it matters on a robot
The container gets the /dev/shm of the host, or of the other container, as large as that is: half of the memory on most
hosts, and 64 MB in a container that says nothing. The size that the point clouds and images of the robot need is not
reserved, and Fast DDS or iceoryx fails where the other one is smaller.

## Bad
```yaml
ipc: host
shm_size: 512m
```

## Good
```yaml
ipc: shareable
shm_size: 512m
```

## When to ignore it
When the size is only kept for a day on which the service gets its own memory again.

## References
- https://docs.docker.com/reference/compose-file/services/#shm_size
- docker-run(1), "--ipc"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import Service


@rule("warning", silent="docker ignores the size")
def shm_size_ignored(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        ipc, size = service.scalar("ipc"), service.scalar("shm_size")
        if ipc is not None and size is not None and (ipc == "host" or ipc.startswith(("service:", "container:"))):
            owner = "the host" if ipc == "host" else ipc.partition(":")[2]
            yield finding(
                size,
                f"shm_size has no effect: '{service.name}' uses the /dev/shm of {owner}, whatever its size is",
                advice=f"remove it and set the size of /dev/shm of {owner}, or write ipc: shareable",
                related=[note(ipc, "not a shared memory of its own")],
                severity="info" if _shares_nothing(service) else None,
            )


def _shares_nothing(service: Service) -> bool:
    """Whether the service says that its nodes use Cyclone DDS, which needs no shared memory by itself."""
    middleware = service.environment.get("RMW_IMPLEMENTATION")
    return middleware is not None and middleware.value == "rmw_cyclonedds_cpp"
