"""A service runs as root.

## What it finds
`user: root` or `user: "0"`; no `user:` for an image that certainly has none: an official ROS image, or one
that a Dockerfile of the tree builds without USER. For other images as info.

## Why it matters on a robot
Files on bind mounts become root's, shared memory of another user is not readable (topics are listed, no
data arrives), and an intruder is root in the container.

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
                f"Service '{service.name}' runs as root" if certain else f"Service '{service.name}' names no user",
                advice='add user: "1000:1000", or USER to the Dockerfile',
                severity=None if certain else "info",
            )
