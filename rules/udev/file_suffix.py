"""A file in rules.d is not read because of its name.

## What it finds
A file with udev rules below `udev/rules.d` whose name does not end in `.rules`. Backups and leftovers of
editors and package managers (`.bak`, `~`, `.dpkg-old`) are reported as information.

## Why it matters on a robot
udev reads `*.rules` only: none of the links and permissions in the file exist.

## Bad
```udev
/etc/udev/rules.d/99-robot.conf
```

## Good
```udev
/etc/udev/rules.d/99-robot.rules
```

## When to ignore it
If the file is a template or a deliberately disabled variant that a script renames on the robot.

## References
- udev(7), "Rules Files"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

_LEFTOVER = regex(r"~$|\.(?:bak|orig|rej|swp|save|old|disabled|off|dpkg-\w+|rpm\w+|ucf-\w+|\d+)$", re.I)


@rule("warning", silent="udev does not read the file and does not report it")
def file_suffix(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("udev-misnamed"):
        yield finding(
            source,
            f"udev does not read {source.basename}: its name does not end in .rules",
            advice="rename it, or delete it if it is a leftover",
            severity="info" if _LEFTOVER.search(source.basename) else None,
        )
