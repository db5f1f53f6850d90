"""A jump goes to a label that does not exist.

## What it finds
`GOTO` without a `LABEL` of that name in the same file.

## Why it matters on a robot
udev ignores the jump and runs the lines that it should skip, so a rule for one device applies to all devices.

## Bad
```udev
SUBSYSTEM!="tty", GOTO="robot_end"
ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM!="tty", GOTO="robot_end"
ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
LABEL="robot_end"
```

## When to ignore it
Never: a jump cannot leave its file, so a label in another file does not help.

## References
- udev(7), GOTO
- `udevadm verify`: has no matching label
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["has no matching label, ignoring", "GOTO=* has no matching label, ignoring"])
def goto_missing_label(robot: Robot) -> Iterator[Finding]:
    for problem, _ in robot.udev.problems("goto-without-label"):
        yield finding(
            problem.where,
            f"No LABEL is called '{problem.where}': udev ignores the jump and runs the lines it should skip",
            advice=f'add LABEL="{problem.where}"',
        )
