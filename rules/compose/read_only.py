"""A container's file system is writable.

## What it finds
A service without `read_only: true`. Privileged services are reported by `compose/privileged`.

## Why it matters on a robot
Anything that an intruder or a bug writes into the container stays there until the container is created again. Logs
and core dumps fill the disk.

## Bad
```yaml
driver:
  image: robot/driver:1.2
```

## Good
```yaml
driver:
  image: robot/driver:1.2
  read_only: true
```

## When to ignore it
When the program must write to many places of its image, and the container is created again at every start.

## References
- robotics-security guide, container hardening
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="a writable file system works")
def read_only(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.unprivileged_services:
        if service.flag("read_only") is not True:
            yield finding(
                service.name,
                f"Service '{service.name}' has a writable file system",
                advice="add read_only: true, with tmpfs: for logs",
            )
