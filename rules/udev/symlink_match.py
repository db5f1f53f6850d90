"""SYMLINK is compared, but no link is made.

## What it finds
`SYMLINK==` on a line that assigns nothing.

## Why it matters on a robot
The line matches devices that already have the link and makes none. udev drops it because it has no effect.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK=="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## When to ignore it
Never: udev drops the line when it loads the rules.

## References
- udev(7), SYMLINK
- `udevadm verify`: The line has no effect
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["The line has no effect, ignoring"])
def symlink_match(robot: Robot) -> Iterator[Finding]:
    for _, line in robot.udev.problems("no-effect"):
        for token in line.matches("SYMLINK"):
            yield finding(
                token.operator,
                f"SYMLINK{token.operator} only compares with '{token.value}': this line makes no link",
                advice='write SYMLINK+="..."',
                fix=fix("make the link", (token.operator, "+=")),
            )
