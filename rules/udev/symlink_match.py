"""A link is compared where it was meant to be made.

## What it finds
`SYMLINK==` on a line that sets nothing.

## Why it matters on a robot
The line looks for a device that already has the link, and makes none: udev drops it as one without effect.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK=="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## References
- udev(7), SYMLINK
- `udevadm verify`: The line has no effect
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["The line has no effect, ignoring"])
def symlink_match(robot: Robot):
    for _, line in robot.udev.problems("no-effect"):
        for token in line.matches("SYMLINK"):
            yield finding(
                token.operator,
                f"SYMLINK{token.operator} only asks for '{token.value}': no link is made by this line",
                advice='write SYMLINK+="..."',
                fix=fix("make the link", (token.operator, "+=")),
            )
