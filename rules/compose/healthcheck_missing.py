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

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import has_no_healthcheck
from bringup_lint.api.yaml import Mapping


@rule("error", confidence="medium", symptoms=["dependency failed to start: container * has no healthcheck configured"])
def healthcheck_missing(robot: Robot) -> Iterator[Finding]:
    checked = {(_folder(service), str(service.name)) for service in robot.compose.services if _checks(service)}
    for file in robot.compose.files:
        if not file.source.judged or file.source.template or not file.yaml.complete:
            continue
        named = {str(service.name): service for service in file.services}
        for service in file.services:
            for name, condition in _waits(service):
                needed = named.get(str(name))
                if needed is not None and _has_none(robot, needed, checked):
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
        required = settings.scalar("required") if isinstance(settings, Mapping) else None
        if required is not None and required.boolean is False:
            continue
        if condition is not None and condition.value == "service_healthy":
            yield name.value, condition.value


def _folder(service: Service) -> str:
    """Files that are given together lie in one folder."""
    return os.path.dirname(service.source.name)


def _checks(service: Service) -> bool:
    check = service.get("healthcheck")
    disabled = check.scalar("disable") if isinstance(check, Mapping) else None
    return check is not None and (disabled is None or disabled.boolean is not True)


def _has_none(robot: Robot, service: Service, checked: set[tuple[str, str]]) -> bool:
    """Whether neither the service, another file that may be given with it, nor its image has a check."""
    if service.get("extends") is not None or (_folder(service), str(service.name)) in checked:
        return False
    if service.get("healthcheck") is not None:
        return True
    stage = robot.compose.stage(service)
    if stage is None:
        return service.build is None and service.image is not None and has_no_healthcheck(service.image)
    return not _has_check(stage) and not robot.compose.images.is_chosen(stage, tag=False)


def _has_check(stage: Stage) -> bool:
    """Whether an image may have a check: its own, or one that a base gives to what is built on it."""
    later = (str(each.value).upper() for link in stage.chain for each in link.all("ONBUILD"))
    own = stage.last("HEALTHCHECK") is not None or any(each.startswith("HEALTHCHECK") for each in later)
    return own or not has_no_healthcheck(stage.origin)
