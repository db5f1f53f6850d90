"""A link name starts with /dev/.

## What it finds
`SYMLINK+="/dev/..."`.

## Why it matters on a robot
It works, because udev strips the prefix. But link names are relative to /dev everywhere else, and a search
for `robot/imu` in quotes does not find this one.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="/dev/robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## When to ignore it
If your rules use the prefix throughout: udev makes the same links.

## References
- udev(7), SYMLINK
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("info", fix="safe", silent="udev removes the prefix without a message")
def symlink_abs_path(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for link in line.links:
            if link.name.startswith("/dev/") and len(link.name) > 5:
                yield finding(
                    link.name,
                    f"{link.name} works, but link names are relative to /dev",
                    advice=f"write {link.name[5:]}",
                    fix=fix("strip /dev/", (link.name.part(0, 5), "")),
                )
