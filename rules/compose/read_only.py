"""A container's file system is writable.

## What it finds
A service without `read_only: true`.

## Why it matters on a robot
What an intruder or a bug writes into the container stays there until it is made anew; logs and cores fill
the disk.

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

## References
- robotics-security guide, container hardening
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info")
def read_only(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        if service.is_privileged:
            continue
        if service.flag("read_only") is not True:
            yield finding(
                service.name,
                f"Service '{service.name}' has a writable file system",
                advice="add read_only: true, with tmpfs: for logs",
            )
