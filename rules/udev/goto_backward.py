"""A jump goes to a label above it.

## What it finds
`GOTO` to a `LABEL` that stands in an earlier line of the file.

## Why it matters on a robot
udev jumps forward only: it ignores the jump and runs the lines it was to skip.

## Bad
```udev
LABEL="robot"
SUBSYSTEM!="tty", GOTO="robot"
```

## Good
```udev
SUBSYSTEM!="tty", GOTO="robot_end"
LABEL="robot_end"
```

## References
- udev(7), GOTO
- `udevadm verify`: has no matching label
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["has no matching label, ignoring"])
def goto_backward(robot: Robot):
    for problem, _ in robot.udev.problems("goto-backward"):
        yield finding(
            problem.where,
            f"The label '{problem.where}' stands above the jump: udev ignores the jump",
            advice="move the label below the jump",
        )
