"""Nothing restarts a ROS container.

## What it finds
A ROS service without a restart policy. Services in a profile, and services with `restart: "no"`, are not reported.

## Why it matters on a robot
After a crash, or after a reboot of the robot, the container stays down.

## Bad
```yaml
nav:
  image: ros:jazzy
```

## Good
```yaml
nav:
  image: ros:jazzy
  restart: unless-stopped
```

## When to ignore it
When a systemd unit starts and restarts the service, or when it runs once and exits.

## References
- robot-bringup guide, checklist
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info")
def restart_missing(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        if service.is_ros and not service.restarts and service.restart is None and service.get("profiles") is None:
            yield finding(
                service.name,
                f"Nothing restarts '{service.name}' after a crash or a reboot",
                advice="add restart: unless-stopped",
            )
