"""A unit file with execute permission.

## What it finds
In a root file system: a unit file or drop-in with an execute bit.

## Why it matters on a robot
systemd logs "is marked executable" at every load, and among such lines the ones that matter are missed.

## Bad
```
-rwxr-xr-x /etc/systemd/system/rover.service
```

## Good
```
-rw-r--r-- /etc/systemd/system/rover.service
```

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
    for file in robot.units.files:
        source = file.source
        if source.mode is not None and source.link is None and source.mode & 0o111:
            yield finding(
                source,
                f"The file is executable (mode {source.mode:04o}): systemd complains at every load",
                advice="chmod 0644",
            )
