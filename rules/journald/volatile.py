"""The logs are lost at every reboot.

## What it finds
`Storage=volatile` or `Storage=none`, unless the root file system is read-only or overlayroot is set up.

## Why it matters on a robot
Operators switch a failed robot off and on again. After that, the log that would explain the failure is gone.

## Bad
```ini
[Journal]
Storage=volatile
```

## Good
```ini
[Journal]
Storage=persistent
SystemMaxUse=500M
```

## When to ignore it
When the disk must not be written, for example to protect an SD card, or when the logs are sent to another
machine.

## References
- journald.conf(5), "Storage="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "info",
    symptoms=[
        "no persistent journal was found",
        "Data from the specified boot (-1) is not available: No such boot ID in journal",
    ],
)
def volatile(robot: Robot) -> Iterator[Finding]:
    by_design = any(mount.target == "/" and mount.is_read_only for fstab in robot.fstabs for mount in fstab.mounts)
    by_design = by_design or bool(robot.of_kind("overlayroot"))
    if by_design:
        return
    for daemon in robot.journald:
        storage = daemon.get("Storage", read=str)
        if (
            storage is not None
            and storage[1] in ("volatile", "none")
            and storage[0].span.source.judged
            and daemon.certain
        ):
            what = "lost at reboot" if storage[1] == "volatile" else "not kept at all"
            yield finding(storage[0], f"Logs are {what}", advice="set Storage=persistent and SystemMaxUse=")
