"""A unit file with execute permission.

## What it finds
A unit file or drop-in in a root file system that has an execute bit.

## Why it matters on a robot
systemd logs "is marked executable" at every load. Among such lines, the important ones are easily missed.

## Bad
```
-rwxr-xr-x /etc/systemd/system/rover.service
```

## Good
```
-rw-r--r-- /etc/systemd/system/rover.service
```

## When to ignore it
When the file system of the tree cannot store modes, for example on a FAT or SMB share, and the image sets
them later.

## References
- systemd: "Configuration file ... is marked executable. Please remove executable permission bits"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", symptoms=["is marked executable. Please remove executable permission bits"])
def unit_file_executable(robot: Robot) -> Iterator[Finding]:
    for file in robot.units.unit_files:
        source = file.source
        if source.mode is not None and source.link is None and source.mode & 0o111:
            yield finding(
                source,
                f"The file is executable (mode {source.mode:04o}): systemd complains at every load",
                advice="run chmod 0644",
            )
