"""A file in rules.d is not read for its name.

## What it finds
A file with udev rules below `udev/rules.d` whose name does not end in `.rules`. Leftovers of editors and
package managers are for information.

## Why it matters on a robot
udev reads `*.rules` only: none of the links and permissions in it exist.

## Bad
```udev
/etc/udev/rules.d/99-robot.conf
```

## Good
```udev
/etc/udev/rules.d/99-robot.rules
```

## References
- udev(7), "Rules Files"
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_LEFTOVER = re.compile(r"~$|\.(?:bak|orig|rej|swp|save|old|disabled|off|dpkg-\w+|rpm\w+|ucf-\w+|\d+)$", re.I)


@rule("warning")
def file_suffix(robot: Robot):
    for source in robot.of_kind("udev-misnamed"):
        yield finding(
            source,
            f"udev does not read {source.basename}: its name does not end in .rules",
            advice="rename it, or remove it if it is a leftover",
            severity="info" if _LEFTOVER.search(source.basename) else None,
        )
