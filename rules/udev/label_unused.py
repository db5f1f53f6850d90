"""A label is the goal of no jump.

## What it finds
A `LABEL` that no `GOTO` of the file names.

## Why it matters on a robot
Often the jump that should lead there is gone or misspelled, and the lines between run for every device.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
LABEL="robot_end"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## References
- `udevadm verify`: LABEL is unused
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info")
def label_unused(robot: Robot):
    for problem, _ in robot.udev.problems("label-unused"):
        yield finding(
            problem.where,
            f"No GOTO leads to the label '{problem.where}'",
            advice="delete it, or add the jump",
        )
