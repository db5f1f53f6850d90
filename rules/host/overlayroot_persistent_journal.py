"""The persistent journal is on an overlay in memory.

## What it finds
`overlayroot="tmpfs"` together with `Storage=persistent` in the configuration of journald.

## Why it matters on a robot
The journal is meant to survive reboots but is stored in memory: after a crash there is nothing to read, and it uses
up the robot's memory.

## Bad
```
overlayroot="tmpfs"      Storage=persistent
```

## Good
```
overlayroot="tmpfs"      Storage=volatile
```

## When to ignore it
When /var/log/journal is mounted from a data partition, by means other than the fstab of this tree.

## References
- overlayroot.conf
- journald.conf(5), "Storage="
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

OVERLAY = regex(r"^[ \t]*overlayroot=[\"']?(tmpfs)", re.M)


@rule("warning", symptoms=["Data from the specified boot (-1) is not available: No such boot ID in journal"])
def overlayroot_persistent_journal(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("overlayroot"):
        overlay = OVERLAY.search(source.said)
        if not overlay:
            continue
        for journald in robot.journald:
            storage = journald.get("Storage", read=lambda text: text or None)
            if storage is not None and storage[1] == "persistent":
                yield finding(
                    storage[0],
                    "The journal does not survive a reboot: the root is an overlay in memory",
                    advice="put /var/log/journal on a data partition, or write Storage=volatile",
                    related=[note(source.located(*overlay.span(1)), "the overlay")],
                )
