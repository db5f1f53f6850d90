"""A rule sets a property that rules cannot set.

## What it finds
An assignment to `ENV{DEVNAME}`, `ENV{SUBSYSTEM}`, `ENV{ACTION}` or another property that belongs to the
kernel or to udev itself.

## Why it matters on a robot
udev drops the whole line, including the link and the permissions on it.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", ENV{DEVNAME}="/dev/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="imu"
```

## When to ignore it
Never: udev rejects the assignment and drops everything else on the line with it.

## References
- udev(7), ENV
- `udevadm verify`: Invalid ENV attribute
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Invalid ENV attribute"])
def env_readonly(robot: Robot) -> Iterator[Finding]:
    for problem, _ in robot.udev.problems("read-only-property"):
        yield finding(
            problem.where,
            f"ENV{{{problem.where}}} cannot be set: udev drops the whole line",
            advice="use a property name of your own",
        )
