"""logrotate ignores a file that others may write to.

## What it finds
A file in /etc/logrotate.d of a root file system that group or others may write to, or that root does not own.

## Why it matters on a robot
logrotate skips the file, prints one line and exits with status 0. The logs grow until the disk is full.

## Bad
```ini
-rw-rw-r-- root robot /etc/logrotate.d/robot
```

## Good
```ini
-rw-r--r-- root root /etc/logrotate.d/robot
```

## When to ignore it
When the image build sets owner and mode after this tree was exported. On the robot itself, logrotate always
skips such a file.

## References
- logrotate(8)
- logrotate: "Ignoring ... because it is writable by group or others"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=["because it is writable by group or others", "because the file owner is wrong"],
    tags=["CWE-732"],
)
def file_mode(robot: Robot) -> Iterator[Finding]:
    if robot.tree.root is None:
        return
    owner = robot.tree.find("/etc/passwd")
    for file in robot.logs.files:
        source = file.source
        if source.mode is None or not (source.robot_path or "").startswith("/etc/logrotate"):
            continue
        if source.mode & 0o022:
            yield finding(
                source,
                f"logrotate ignores the file: group or others may write to it (mode {source.mode:04o})",
                advice=f"chmod 0644 {source.robot_path}",
            )
        elif owner is not None and source.uid != owner.uid:
            yield finding(
                source,
                "logrotate ignores the file: root does not own it",
                advice=f"chown root {source.robot_path}",
            )
