"""Nothing removes old logs: the disk fills up.

## What it finds
A ROS_LOG_DIR or an `append:` file of a unit that no logrotate stanza, no tmpfiles.d age and no script or
timer of the tree covers. It is a warning in a complete root file system, and an info in a repository, where
the cleanup may be elsewhere.

## Why it matters on a robot
ROS does not limit the size of its logs, and each run writes new files. When the disk is full, maps cannot be
saved, the journal stops, and the robot may not boot.

## Bad
```
[Service]
Environment=ROS_LOG_DIR=/var/log/ros2
```

## Good
```
# /etc/tmpfiles.d/ros2.conf
e /var/log/ros2 - - - 14d
```

## When to ignore it
When something outside of this tree cleans up, such as the base image or a fleet agent, or when the folder is
on a tmpfs or a partition of its own.

## References
- tmpfiles.d(5), "Age"
- <https://github.com/ros2/rcl_logging/issues/100>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["No space left on device"])
def missing(robot: Robot) -> Iterator[Finding]:
    for log in robot.logs.uncovered():
        advice = f"add 'e {log.path} - - - 14d' to tmpfiles.d" if log.folder else f"rotate {log.path} with logrotate"
        yield finding(
            log.where,
            f"Nothing removes old logs in {log.path}: the disk fills up"
            if log.folder
            else f"Nothing rotates {log.path}: it grows until the disk is full",
            advice=advice,
            related=[note(log.unit.where, f"{log.unit.name} writes there")] if log.folder else (),
            severity=None if robot.tree.complete else "info",
        )
