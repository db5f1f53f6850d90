"""A log directory is gone after every boot.

## What it finds
A directory below a tmpfs (`/var/log`, `/tmp`, ...) that a unit needs — as `ROS_LOG_DIR`, in
`StandardOutput=file:` or `append:`, in `ReadWritePaths=` — and that nothing makes at boot: no tmpfiles.d
line, no `LogsDirectory=`, no `mkdir` or `install -d` of the unit itself.

## Why it matters on a robot
The directory was made by hand once and works until the next boot. Then every node fails to open its log, or
the unit ends with 209/STDOUT or 226/NAMESPACE.

## Bad
```
tmpfs /var/log tmpfs …      Environment=ROS_LOG_DIR=/var/log/ros2
```

## Good
```
LogsDirectory=ros2          Environment=ROS_LOG_DIR=/var/log/ros2
```

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


@rule("error", symptoms=["Failed at step STDOUT spawning", "Failed to set up mount namespacing"])
def varlog_tmpfs_dirs(robot: Robot) -> Iterator[Finding]:
    for mount, path, where, unit in robot.lost_directories:
        yield finding(
            where,
            f"{path} is gone after every boot: {mount.target} is a tmpfs, and nothing makes the directory",
            advice=f"add LogsDirectory= to {unit.name}, or a tmpfiles.d line: d {path} 0755 robot robot -",
            related=[note(mount.target, "the tmpfs")],
        )
