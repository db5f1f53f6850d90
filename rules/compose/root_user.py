"""A service runs as root.

## What it finds
`user: root` or `user: "0"`. Also a service without `user:` whose image certainly runs as root: an official ROS
image, or one that a Dockerfile of the tree builds without USER. Other images without `user:` are info.

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
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", tags=["CWE-250"])
def root_user(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        user = service.user
        if user is not None:
            if user.partition(":")[0] in ("root", "0"):
                yield finding(
                    user,
                    f"Service '{service.name}' runs as root",
                    advice='write user: "1000:1000", or the ids of the robot\'s user',
                )
            continue
        known = robot.compose.image_user(service)
        if known in (None, "root", "0"):
            certain = known is not None
            yield finding(
                service.name,
                f"Service '{service.name}' runs as root" if certain else f"Service '{service.name}' sets no user",
                advice='add user: "1000:1000" here, or USER to the Dockerfile',
                severity=None if certain else "info",
            )
