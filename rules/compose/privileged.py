"""A privileged container.

## What it finds
`privileged: true`.

## Why it matters on a robot
The container may do everything on the host: load modules, write every disk, read every key. A flaw in one
node is the robot.

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
                advice="name what it needs: devices:, device_cgroup_rules:, cap_add:",
            )
