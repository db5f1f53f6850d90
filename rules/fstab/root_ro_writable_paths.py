"""A service writes to a read-only root.

## What it finds
`/` is mounted `ro`, and a unit writes to a path on it: its `ROS_LOG_DIR`, or the file of `StandardOutput=`.

## Why it matters on a robot
`Read-only file system`: every node fails to open its log, or the unit fails with 209/STDOUT.

## Bad
```
/dev/mmcblk0p2 / ext4 ro …   Environment=ROS_LOG_DIR=/opt/robot/log
```

## Good
```
/dev/mmcblk0p2 / ext4 ro …   Environment=ROS_LOG_DIR=/data/log
```

## When to ignore it
When an overlay, which is set up outside of fstab, makes the path writable.

## References
- robotics-security guide, read-only root
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["Read-only file system"])
def root_ro_writable_paths(robot: Robot) -> Iterator[Finding]:
    for mount, path, where, unit in robot.mounts.read_only_writes:
        yield finding(
            where,
            f"{unit.name} writes to {path}, but / is read-only",
            advice="move it to a data partition or a tmpfs",
            related=[note(mount.place, "mounted read-only")],
        )
