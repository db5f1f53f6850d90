"""Everything that is written to an overlay root is lost.

## What it finds
`overlayroot="tmpfs"` together with `Storage=persistent` of journald.

## Why it matters on a robot
The journal is set to survive reboots and lies in memory: after a crash there is nothing to read, and it
eats the memory of the robot.

## Bad
```
overlayroot="tmpfs"      Storage=persistent
```

## Good
```
overlayroot="tmpfs"      Storage=volatile
```

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
from bringup_lint.api import rule

OVERLAY = re.compile(r"^[ \t]*overlayroot=[\"']?(tmpfs)", re.M)


@rule("warning")
def overlayroot_persistent_journal(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("overlayroot"):
        overlay = OVERLAY.search(source.text)
        for journald in robot.journald if overlay else ():
            storage = journald.get("Storage", read=lambda text: text or None)
            if storage is not None and storage[1] == "persistent":
                yield finding(
                    storage[0],
                    "The journal is not persistent: the root is an overlay in memory",
                    advice="put /var/log/journal on a data partition, or write Storage=volatile",
                    related=[note(source.located(*overlay.span(1)), "the overlay")],
                )
