r"""A rule matches but does nothing.

## What it finds
A line with matches only: no assignment, no jump, no label, no program. A line with `SYMLINK==` is reported by
udev/symlink-match.

## Why it matters on a robot
udev drops the line. Usually an assignment was lost, or a backslash is missing at the end of the line and the
next line has become a rule of its own that fires for every device.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT",
  SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", \
  SYMLINK+="robot/imu"
```

## When to ignore it
If the line is a placeholder and you accept the message that udev logs each time it loads the rules.

## References
- udev(7), "Rules Files"
- `udevadm verify`: The line has no effect
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", symptoms=["The line has no effect, ignoring"])
def no_effect(robot: Robot) -> Iterator[Finding]:
    for problem, line in robot.udev.problems("no-effect"):
        if not line.matches("SYMLINK"):
            yield finding(
                problem.where,
                "The line assigns nothing: udev drops it",
                advice="add the assignment, or end the line with a backslash if the next one belongs to it",
            )
