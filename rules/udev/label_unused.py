"""No jump leads to a label.

## What it finds
A `LABEL` that no `GOTO` of the same file names.

## Why it matters on a robot
The jump that should lead there may be missing or misspelled. The lines that it should skip then run for every
device.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
LABEL="robot_end"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## When to ignore it
If the label only marks the end of the file by convention and no jump is missing.

## References
- `udevadm verify`: LABEL is unused
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", symptoms=['LABEL="*" is unused.'])
def label_unused(robot: Robot) -> Iterator[Finding]:
    for problem, _ in robot.udev.problems("label-unused"):
        yield finding(
            problem.where,
            f"No GOTO leads to the label '{problem.where}'",
            advice="delete it, or add the jump",
        )
