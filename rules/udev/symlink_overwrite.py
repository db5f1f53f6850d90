"""A rule throws away the links made before it.

## What it finds
`SYMLINK=` with a plain equals sign.

## Why it matters on a robot
The links that earlier rules gave the device are gone, and whatever opens the device by one of them fails. The links
in `/dev/serial/by-id` and `by-path` are made by `60-serial.rules`: a file that is read later drops them too.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## References
- udev(7), SYMLINK and "Operators"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="safe")
def symlink_overwrite(robot: Robot):
    for line in robot.udev.judged:
        for token in line.line.assignments("SYMLINK"):
            if token.operator == "=":
                late = line.source.basename > "60-serial.rules"
                yield finding(
                    token.operator,
                    "SYMLINK= drops the links that rules before it gave the device"
                    + (", such as those by id" if late else ""),
                    advice="write +=",
                    fix=fix("add the link", (token.operator, "+=")),
                )
