"""A container keeps the default capabilities.

## What it finds
A service without `cap_drop: [ALL]`. Privileged services are reported by `compose/privileged`.

## Why it matters on a robot
The default set allows raw sockets, changing the owner of files and more. Few nodes need any of it.

## Bad
```yaml
driver:
  image: robot/driver:1.2
```

## Good
```yaml
driver:
  image: robot/driver:1.2
  cap_drop: [ALL]
```

## When to ignore it
When the service needs most of the default capabilities, for example a container that installs packages at run time.

## References
- robotics-security guide, container hardening
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="unused capabilities show only when somebody abuses them")
def cap_drop_missing(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.unprivileged_services:
        if "ALL" not in [item.upper() for item in service.items("cap_drop")]:
            yield finding(
                service.name,
                f"Service '{service.name}' keeps Docker's default capabilities",
                advice="add cap_drop: [ALL], and cap_add for the capabilities that it needs",
            )
