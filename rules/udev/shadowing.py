"""A rules file replaces one of the distribution.

## What it finds
A file that has the name of a packaged rules file and is in a folder of higher precedence. An empty file or a
link to /dev/null is the documented way to disable a packaged file and is not reported.

## Why it matters on a robot
udev reads only the file in /etc: what the packaged file did, such as the links in /dev/serial/by-id, is gone.

## Bad
```udev
/etc/udev/rules.d/60-serial.rules
```

## Good
```udev
/etc/udev/rules.d/99-robot-serial.rules
```

## When to ignore it
If the file is an adapted copy of the packaged one and keeps what the robot needs. Compare it with the
packaged file after each upgrade.

## References
- udev(7), "Rules Files"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", symptoms=["[OVERRIDDEN] /etc/udev/rules.d/* → /*/udev/rules.d/*"])
def shadowing(robot: Robot) -> Iterator[Finding]:
    for file, hidden, package in robot.udev.replacing:
        name = hidden.name if hidden is not None else ""
        yield finding(
            file.source,
            f"udev reads this file instead of the one with the same name from {package or name}",
            advice="choose another name, unless you want to disable the packaged rules",
            related=[note(hidden, "is not read")] if hidden else [],
        )
