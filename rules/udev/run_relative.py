"""A program is given without its path.

## What it finds
`RUN`, `PROGRAM` or `IMPORT{program}` with the bare name of a common command, such as `chmod`, `sh` or
`systemctl`.

## Why it matters on a robot
udev looks for bare names in /usr/lib/udev only, not in PATH. It does not find the program and reports that
only in the journal.

## Bad
```udev
KERNEL=="ttyACM*", RUN+="sh -c 'echo 1 > /sys$devpath/device/enable'"
```

## Good
```udev
KERNEL=="ttyACM*", RUN+="/bin/sh -c 'echo 1 > /sys$devpath/device/enable'"
```

## When to ignore it
If you install a program of this name in /usr/lib/udev yourself.

## References
- udev(7), RUN: "If no absolute path is given, the program is expected to live in /usr/lib/udev"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=["Failed to execute '/usr/lib/udev/*': No such file or directory", "Failed to execute '/lib/udev/"],
)
def run_relative(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for command in line.commands:
            if command.is_looked_up_in_vain:
                yield finding(
                    command.program,
                    f"udev looks for /usr/lib/udev/{command.program}, not in PATH: the program does not run",
                    advice=f"write the absolute path of {command.program}",
                )
