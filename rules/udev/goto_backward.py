"""A jump goes to a label above it.

## What it finds
`GOTO` to a `LABEL` on an earlier line of the file.

## Why it matters on a robot
udev only jumps forward. It ignores the jump and runs the lines that it should skip.

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

## When to ignore it
Never: udev ignores a backward jump, so the line does nothing.

## References
- udev(7), GOTO
- `udevadm verify`: has no matching label
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["has no matching label, ignoring"])
def goto_backward(robot: Robot) -> Iterator[Finding]:
    for problem, _ in robot.udev.problems("goto-backward"):
        yield finding(
            problem.where,
            f"The label '{problem.where}' is above the jump: udev ignores the jump and runs the lines it should skip",
            advice="move the label below the jump",
        )
