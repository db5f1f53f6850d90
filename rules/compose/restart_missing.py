"""Nothing restarts a ROS container.

## What it finds
A ROS service without a restart policy. Services in a profile, and services with `restart: "no"`, are not reported.
It is a warning for a service that launches ROS with devices of the robot and is the bring-up by
its name or launch file, where nothing of the tree calls docker compose.

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

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service

CALLS = regex(r"\bdocker(?:-compose|[ \t]+compose)\b[^\n]{0,200}\bup\b")
BRINGUP = regex(r"bring_?up|robot\.launch", re.I)
SIMULATION = regex(r"gazebo|\bsim|gz|rviz|webots", re.I)


@rule("info", symptoms=["exited with code 1"])
def restart_missing(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        if service.is_ros and not service.restarts and service.restart is None and service.get("profiles") is None:
            yield finding(
                service.name,
                f"Nothing restarts '{service.name}' after a crash or a reboot",
                advice="add restart: unless-stopped",
                severity="warning" if _drives(service) and not robot.mentions(CALLS) else None,
            )


def _drives(service: Service) -> bool:
    """Whether the service launches the robot itself, with its devices."""
    has_devices = bool(service.devices) or service.is_privileged
    if not has_devices or service.launches is None:
        return False
    words = " ".join([service.name, *service.command, *service.entrypoint])
    return BRINGUP.search(words) is not None and SIMULATION.search(words) is None
