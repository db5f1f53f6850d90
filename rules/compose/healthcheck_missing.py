"""A service waits until another one is healthy, and nothing checks its health.

## What it finds
`depends_on` with `condition: service_healthy` for a service without `healthcheck` (or with a disabled one) whose image
has none either: an official image of ROS, Ubuntu or Debian, or one that a Dockerfile of the tree builds on such an
image without HEALTHCHECK.

## Why it matters on a robot
docker compose stops with "dependency failed to start: container ... has no healthcheck configured": the service that
waits never starts.

## Bad
```yaml
services:
  base:
    image: ros:jazzy
  nav:
    image: ros:jazzy
    depends_on:
      base: {condition: service_healthy}
```

## Good
```yaml
services:
  base:
    image: ros:jazzy
    healthcheck:
      test: ["CMD", "bash", "-c", ". /opt/ros/jazzy/setup.bash && ros2 topic list | grep -q /odom"]
  nav:
    image: ros:jazzy
    depends_on:
      base: {condition: service_healthy}
```

## When to ignore it
When another compose file that is always given adds the check.

## References
- https://docs.docker.com/reference/compose-file/services/#depends_on
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import has_no_healthcheck
from bringup_lint.api.yaml import Mapping


@rule("error", confidence="medium", symptoms=["dependency failed to start: container * has no healthcheck configured"])
def healthcheck_missing(robot: Robot) -> Iterator[Finding]:
    for file in robot.compose.files:
        if not file.source.judged or file.source.template:
            continue
        named = {str(service.name): service for service in file.services}
        for service in file.services:
            for name, condition in _waits(service):
                needed = named.get(str(name))
                if needed is not None and _has_none(robot, needed):
                    yield finding(
                        condition,
                        f"Nothing checks the health of '{name}': docker compose refuses to start '{service.name}'",
                        advice=f"give '{name}' a healthcheck, or write condition: service_started",
                        related=[note(needed.name, "has no healthcheck")],
                    )


def _waits(service: Service) -> Iterator[tuple[Located, Located]]:
    """The services that have to be healthy, each with the word that says so."""
    node = service.get("depends_on")
    if not isinstance(node, Mapping):
        return
    for name, settings in node.merged:
        condition = settings.scalar("condition") if isinstance(settings, Mapping) else None
        if condition is not None and condition.value == "service_healthy":
            yield name.value, condition.value


def _has_none(robot: Robot, service: Service) -> bool:
    if service.get("extends") is not None:
        return False
    check = service.get("healthcheck")
    if check is not None:
        disabled = check.scalar("disable") if isinstance(check, Mapping) else None
        return disabled is not None and disabled.boolean is True
    stage = robot.compose.stage(service)
    if stage is None:
        return service.build is None and service.image is not None and has_no_healthcheck(service.image)
    return has_no_healthcheck(stage.origin) and stage.last("HEALTHCHECK") is None
