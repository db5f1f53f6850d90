"""A service runs as root.

## What it finds
`user: root` or `user: "0"`. Also a service without `user:` whose image certainly runs as root, such as an official ROS
image; services of one file with the same image are one finding. If a Dockerfile of the tree builds the image,
`docker/root-user` reports it there. Services without `user:` whose image is not known are info, as is `user: root` in a
file without ROS and devices: that is a server.

## Why it matters on a robot
Files on bind mounts belong to root. Shared memory of another user is not readable: topics are listed, but no data
arrives. An intruder is root in the container.

## Bad
```yaml
nav:
  image: ros:jazzy
```

## Good
```yaml
nav:
  image: ros:jazzy
  user: "1000:1000"
```

## When to ignore it
When the entrypoint of the image starts as root and then switches to another user.

## References
- robotics-security guide, container hardening
- CWE-250
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.compose import reach

ADVICE = 'write user: "1000:1000", or the ids of the robot\'s user'
IN_BOTH = 'add user: "1000:1000" here, or USER to the Dockerfile'


@rule("warning", silent="root may do everything, so nothing fails", tags=["CWE-250"])
def root_user(robot: Robot) -> Iterator[Finding]:
    by_file: dict[Source, list[Service]] = {}
    for service in robot.compose.whole_services:
        by_file.setdefault(service.source, []).append(service)
    for services in by_file.values():
        own = [service for service in services if service.user is not None]
        yield from _chosen(
            [service for service in own if _is_root(robot, service)], None if _is_robot(services) else "info"
        )
        yield from _left_to_image(robot, [service for service in services if service.user is None])


def _is_root(robot: Robot, service: Service) -> bool:
    runner = robot.runners.of_service(service)
    return runner is not None and runner.user == "root"


def _is_robot(services: list[Service]) -> bool:
    """Whether a file has something of a robot: ROS, or devices; else it is a server beside it."""
    return any(service.is_ros or service.devices or service.is_privileged for service in services)


def _chosen(services: list[Service], severity: str | None) -> Iterator[Finding]:
    by_place = {service.user.span: service for service in reversed(services) if service.user is not None}
    for place, service in by_place.items():
        message = f"Service '{service.name}' runs as root{reach(service)}"
        yield finding(place, message, advice=ADVICE, severity=severity)


def _left_to_image(robot: Robot, services: list[Service]) -> Iterator[Finding]:
    images: dict[str, list[Service]] = {}
    for service in services:
        if robot.compose.stage(service) is not None:
            continue
        if _is_root(robot, service):
            images.setdefault(str(service.image), []).append(service)
        else:
            yield finding(service.name, f"Service '{service.name}' sets no user", advice=ADVICE, severity="info")
    for first, *others in images.values():
        related = [note(other.name, "has the same image") for other in others]
        yield finding(first.name, f"Service '{first.name}' runs as root{reach(first)}", advice=IN_BOTH, related=related)
