"""A rule removes the links made by earlier rules.

## What it finds
`SYMLINK=` with a plain equals sign.

## Why it matters on a robot
The links that earlier rules gave the device are gone, and whatever opens the device by one of them fails.
`60-serial.rules` makes the links in `/dev/serial/by-id` and `by-path`: a file that is read later removes them
too.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## When to ignore it
If the device must have this one name and nothing on the robot opens it by another, including
`/dev/serial/by-id`.

## References
- udev(7), SYMLINK and "Operators"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="unsafe", silent="udev drops the other links without a message")
def symlink_overwrite(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for token in line.line.assignments("SYMLINK"):
            if token.operator == "=":
                late = line.source.basename > "60-serial.rules"
                yield finding(
                    token.operator,
                    "SYMLINK= removes the links that earlier rules gave the device"
                    + (", such as those in by-id" if late else ""),
                    advice="write +=",
                    fix=fix("add the link", (token.operator, "+=")),
                    severity=None if late else "info",
                )
