"""A container is privileged.

## What it finds
`privileged: true`.

## Why it matters on a robot
The container can do everything on the host: load modules, write to every disk, read every key. A flaw in one node
compromises the robot.

## Bad
```yaml
driver:
  image: robot/driver:1.2
  privileged: true
```

## Good
```yaml
driver:
  image: robot/driver:1.2
  devices: [/dev/robot/lidar]
  cap_add: [SYS_NICE]
```

## When to ignore it
When the service is a tool for commissioning that never runs in operation.

## References
- robotics-security guide, container hardening
- CWE-250
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", tags=["CWE-250"])
def privileged(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        if service.is_privileged and service.body.get("privileged") is not None:
            yield finding(
                service.key("privileged"),
                f"Service '{service.name}' has all rights on the host",
                advice="list what it needs instead: devices:, device_cgroup_rules:, cap_add:",
            )
