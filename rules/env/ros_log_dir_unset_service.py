"""A service has no folder for its ROS logs.

## What it finds
A unit that runs ROS, has no home folder, and sets none of ROS_LOG_DIR, ROS_HOME and HOME, as far as its whole
environment is known. A unit has no home folder with `DynamicUser=yes`, or, in a root file system, with a `User=`
whose home is `/nonexistent` or does not exist.

## Why it matters on a robot
Every node writes to `~/.ros/log` as soon as it starts. It fails with `Failed to create log directory` and exits.

## Bad
```ini
User=robot                 # /etc/passwd: robot:x:990:990::/nonexistent:/usr/sbin/nologin
ExecStart=/opt/lawn/start
```

## Good
```ini
User=robot
LogsDirectory=ros2
Environment=ROS_LOG_DIR=/var/log/ros2
```

## When to ignore it
When a script that is not in the tree sets ROS_LOG_DIR, or when the home folder is created before the service
starts.

## References
- rcl_logging_interface, how the log directory is found
- systemd.exec(5), LogsDirectory=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit

SETS = ("ROS_LOG_DIR", "ROS_HOME", "HOME")


@rule(
    "info",
    symptoms=[
        "Failed to create log directory",
        "Failed to get logging directory",
        "Permission denied: '/home/*/.ros",
        "Permission denied: '/*/.ros",
    ],
)
def ros_log_dir_unset_service(robot: Robot) -> Iterator[Finding]:
    for process in robot.ros.processes:
        unit = process.unit
        if unit is None or unit not in robot.units.ros or unit.manager != "system":
            continue
        if any(process.environment.defines(name) is not False for name in SETS):
            continue
        reason = _homeless(robot, unit)
        if reason is not None and unit.get("WorkingDirectory") != "~":
            where, why = reason
            yield finding(
                where,
                f"{why}: ROS cannot write its logs, and {process.name} does not start",
                advice="add LogsDirectory=ros2 and Environment=ROS_LOG_DIR=/var/log/ros2",
                related=[note(process.where, "runs ROS")],
            )


def _homeless(robot: Robot, unit: Unit) -> tuple[Located | Span, str] | None:
    """The place that says that the service has no home, and why."""
    if unit.unsure_of("User", "DynamicUser", section="Service"):
        return None
    identity = unit.identity
    if identity.dynamic and identity.dynamic.at is not None:
        return identity.dynamic.at, "A dynamic user has no home"
    user = identity.user
    home = robot.accounts.home_of(str(identity.name)) if user and robot.tree.complete else None
    if user is not None and home and (home == "/nonexistent" or robot.tree.has(home) is False):
        return user, f"The home of {user}, {home}, does not exist"
    return None
