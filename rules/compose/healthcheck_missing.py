"""A service waits until another one is healthy, and nothing checks its health.

## What it finds
`depends_on` with `condition: service_healthy` for a service without `healthcheck` (or with a disabled one) whose image
has none either: an official image (ROS, Ubuntu, Debian, postgres, redis, eclipse-mosquitto and others), the agent of
micro-ROS, or one that a Dockerfile of the tree builds on such an image without HEALTHCHECK.

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
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import unchecked_health


@rule("error", confidence="medium", symptoms=["dependency failed to start: container * has no healthcheck configured"])
def healthcheck_missing(robot: Robot) -> Iterator[Finding]:
    for waiting, needed, condition in unchecked_health(robot.compose):
        yield finding(
            condition,
            f"Nothing checks the health of '{needed.name}': docker compose refuses to start '{waiting.name}'",
            advice=f"give '{needed.name}' a healthcheck, or write condition: service_started",
            related=[note(needed.name, "has no healthcheck")],
        )
