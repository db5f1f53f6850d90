"""A match key is written with a single equals sign.

## What it finds
An assignment operator after `SUBSYSTEM`, `KERNEL`, `ATTRS{...}` or another key that can only be matched.

## Why it matters on a robot
udev logs an invalid operator in the journal and drops the whole line: no link, no permissions.

## Bad
```udev
SUBSYSTEM="tty", ATTRS{idVendor}="0403", SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", SYMLINK+="robot/imu"
```

## When to ignore it
Never: udev rejects the whole line, so it has no effect as it is.

## References
- udev(7), "Operators" and "Matches"
- `udevadm verify`: Invalid operator
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule(
    "error",
    fix="unsafe",
    symptoms=["Invalid operator for SUBSYSTEM", "Invalid operator for KERNEL", "Invalid operator for ATTRS"],
)
def assign_instead_of_match(robot: Robot) -> Iterator[Finding]:
    for problem, _ in robot.udev.problems("match-only-key"):
        yield finding(
            problem.where,
            f"{problem.detail} cannot be assigned, a match needs ==: udev drops the whole line",
            advice="write == instead",
            fix=fix("write ==", (problem.where, "==")),
        )
