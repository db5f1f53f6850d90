"""NAME= is used for a device that is not a network interface.

## What it finds
`NAME=` in a rule for tty, video, USB or other devices that are not network interfaces.

## Why it matters on a robot
udev can rename network interfaces only: it ignores the key, and the name does not appear in /dev.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", NAME="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## When to ignore it
Never: current versions of udev ignore the key for every other device.

## References
- udev(7), NAME
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Only network interfaces can be renamed, ignoring"])
def name_not_net(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        if not line.subsystems or "net" in line.subsystems:
            continue
        for token in line.line.assignments("NAME"):
            subsystem = "/".join(sorted(line.subsystems))
            yield finding(
                token.span,
                f"NAME= renames network interfaces only: no {subsystem} device gets the name '{token.value}'",
                advice=f'write SYMLINK+="{token.value}"',
                fix=fix(
                    "make a link",
                    (line.source.span(token.key.span.start, token.operator.span.end), "SYMLINK+="),
                ),
            )
