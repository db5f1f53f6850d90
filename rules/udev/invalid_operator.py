"""A key is used with an operator that it does not accept.

## What it finds
An operator that udev refuses for a key that can be assigned: `GROUP==`, `MODE==`, `RUN-=`, `PROGRAM-=`,
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

## When to ignore it
Never: udev drops the whole line.

## References
- udev(7), "Operators"
- `udevadm verify`: Invalid operator
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Invalid operator for GROUP", "Invalid operator for MODE", "Invalid operator for RUN"])
def invalid_operator(robot: Robot) -> Iterator[Finding]:
    for problem, _ in robot.udev.problems("invalid-operator"):
        yield finding(
            problem.where,
            f"{problem.detail} does not accept {problem.where}: udev drops the whole line",
            advice="write = or +=" if problem.detail == "RUN" else "write =",
        )
