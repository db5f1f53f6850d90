"""A log directory disappears at every boot.

## What it finds
A directory below a tmpfs (`/var/log`, `/tmp`, ...) that a unit needs (as `ROS_LOG_DIR`, in `StandardOutput=file:`
or `append:`, in `ReadWritePaths=`) but that nothing creates at boot: no tmpfiles.d line, no `LogsDirectory=`, and
no `mkdir` or `install -d` in the unit itself.

## Why it matters on a robot
Somebody created the directory by hand, and it works until the next boot. Then every node fails to open its log, or
the unit fails with 209/STDOUT or 226/NAMESPACE.

## Bad
```
tmpfs /var/log tmpfs …      Environment=ROS_LOG_DIR=/var/log/ros2
```

## Good
```
LogsDirectory=ros2          Environment=ROS_LOG_DIR=/var/log/ros2
```

## When to ignore it
When another service that is not in the tree creates the directory before this unit starts.

## References
- systemd.exec(5), "LogsDirectory="
- tmpfiles.d(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "Failed at step STDOUT spawning",
        "Failed to set up mount namespacing",
        "status=209/STDOUT",
        "Failed to set up standard output: No such file or directory",
    ],
)
def varlog_tmpfs_dirs(robot: Robot) -> Iterator[Finding]:
    for mount, path, where, unit in robot.mounts.missing_directories:
        yield finding(
            where,
            f"{path} is gone after every boot: {mount.place} is a tmpfs, and nothing creates the directory",
            advice=f"add LogsDirectory= to {unit.name}, or a tmpfiles.d line: d {path} 0755 robot robot -",
            related=[note(mount.place, "the tmpfs")],
        )
