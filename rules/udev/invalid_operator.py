"""A key is written with an operator that it does not take.

## What it finds
Operators that udev refuses for a key that can be assigned: `GROUP==`, `MODE==`, `RUN-=`, `PROGRAM-=`,
`LABEL+=` and others.

## Why it matters on a robot
udev drops the whole line: no link, no permissions, no program.

## Bad
```udev
KERNEL=="ttyACM*", GROUP=="dialout"
```

## Good
```udev
KERNEL=="ttyACM*", GROUP="dialout"
```

## References
- udev(7), "Operators"
- `udevadm verify`: Invalid operator
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Invalid operator for GROUP", "Invalid operator for MODE", "Invalid operator for RUN"])
def invalid_operator(robot: Robot):
    for problem, _ in robot.udev.problems("invalid-operator"):
        yield finding(
            problem.where,
            f"{problem.detail} does not take {problem.where}: udev drops the whole line",
            advice="write = or +=" if problem.detail == "RUN" else "write =",
        )
