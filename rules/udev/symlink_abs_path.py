"""A link is written with /dev/ in front.

## What it finds
`SYMLINK+="/dev/..."`.

## Why it matters on a robot
It works, since udev strips the prefix, but link names are relative to /dev everywhere else, and people search
for them so.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="/dev/robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## References
- udev(7), SYMLINK
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("info", fix="safe")
def symlink_abs_path(robot: Robot):
    for line in robot.udev.judged:
        for link in line.links:
            if link.name.startswith("/dev/") and len(link.name) > 5:
                yield finding(
                    link.name,
                    f"{link.name} works, but the names of links are relative to /dev",
                    advice=f"write {link.name[5:]}",
                    fix=fix("strip /dev/", (link.name.part(0, 5), "")),
                )
