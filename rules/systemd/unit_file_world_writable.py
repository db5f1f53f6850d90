"""A unit file that every user can change.

## What it finds
A unit file or drop-in in a root file system that is writable for everybody.

## Why it matters on a robot
Anyone who gets an account on the robot, through a node or a web page, can add a command to the file. It runs
as root at the next boot.

## Bad
```
-rw-rw-rw- /etc/systemd/system/rover.service
```

## Good
```
-rw-r--r-- /etc/systemd/system/rover.service
```

## When to ignore it
When the file system of the tree cannot store modes, for example on a FAT or SMB share, and the image sets
them later.

## References
- systemd: "Configuration file ... is marked world-writable. Please remove world writability permission
  bits"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "warning",
    tags=["CWE-732"],
    symptoms=["is marked world-writable. Please remove world writability permission bits"],
)
def unit_file_world_writable(robot: Robot) -> Iterator[Finding]:
    for file in robot.units.unit_files:
        source = file.source
        if source.mode is not None and source.link is None and source.mode & 0o002:
            yield finding(
                source,
                f"Every local user can change what this unit runs (mode {source.mode:04o})",
                advice="run chmod 0644",
            )
