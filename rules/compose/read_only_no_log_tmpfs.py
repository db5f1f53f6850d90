"""ROS cannot write its logs in a read-only container.

## What it finds
A ROS service with `read_only: true` whose log directory (`ROS_LOG_DIR`, or else `ROS_HOME` or `HOME`) is on neither
a tmpfs nor a writable volume.

## Why it matters on a robot
Every node creates its log file at start and fails if it cannot: `Failed to initialize logging`. The container
restarts forever.

## Bad
```yaml
nav:
  image: ros:jazzy
  read_only: true
  tmpfs: [/var/log/ros]        # but ROS writes to ~/.ros/log
```

## Good
```yaml
nav:
  image: ros:jazzy
  read_only: true
  tmpfs: [/var/log/ros]
  environment: {ROS_LOG_DIR: /var/log/ros}
```

## When to ignore it
When the image sets `ROS_LOG_DIR` to a writable path in a way that the compose file does not show.

## References
- robotics-security guide, container hardening
- rcl_logging_interface, get_logging_directory
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Failed to create log directory", "Read-only file system"])
def read_only_no_log_tmpfs(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        if service.flag("read_only") is not True or not service.is_ros:
            continue
        if len(robot.compose.env_files(service)) < len(service.env_files):
            continue
        variables = robot.compose.variables(service, "ROS_LOG_DIR", "ROS_HOME", "HOME")
        place = next(iter(variables), None)
        writable = [*service.tmpfs, *(v.target for v in service.volumes if v.target and not v.read_only)]
        if any("$" in path for path in [*writable, *([place[1]] if place else [])]):
            continue
        if place is None:
            lost = not any(path.endswith("/.ros") or path == "/root" or path.startswith("/home/") for path in writable)
            where = "~/.ros/log"
        else:
            lost = not any(f"{place[1]}/".startswith(path.rstrip("/") + "/") for path in writable)
            where = str(place[1])
        if lost:
            yield finding(
                service.place_of("read_only"),
                f"ROS cannot write {where} in '{service.name}': every node fails at start",
                advice="set ROS_LOG_DIR to a directory that tmpfs: or volumes: makes writable",
                related=[note(place[1], "the log directory")] if place else [],
            )
