"""A rules file replaces one of the distribution.

## What it finds
A file with the name of a packaged rules file in a folder of higher precedence.

## Why it matters on a robot
udev reads only the one in /etc: what the packaged file did, such as the links in /dev/serial/by-id, is gone.
An empty file or a link to /dev/null says that this is meant.

## Bad
```udev
/etc/udev/rules.d/60-serial.rules
```

## Good
```udev
/etc/udev/rules.d/99-robot-serial.rules
```

## References
- udev(7), "Rules Files"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info")
def shadowing(robot: Robot):
    for file, hidden, package in robot.udev.replacing:
        yield finding(
            file.source,
            f"udev reads this file instead of the one of its name from {package or hidden.name}",
            advice="choose another name, unless the packaged rules are to be off",
            related=[note(hidden, "is not read")] if hidden else [],
        )
