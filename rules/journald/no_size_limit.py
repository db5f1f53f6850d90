"""Nothing limits the size of a persistent journal.

## What it finds
`Storage=persistent` when no file of the same robot sets SystemMaxUse or SystemKeepFree.

## Why it matters on a robot
The journal may take 10 % of the file system, up to 4 GiB. On the small disk of a robot that also records
bags, the journal can fill the disk.

## Bad
```ini
[Journal]
Storage=persistent
```

## Good
```ini
[Journal]
Storage=persistent
SystemMaxUse=500M
```

## When to ignore it
When /var/log/journal is on a partition of its own, or when 4 GiB is small compared with the disk.

## References
- journald.conf(5), "SystemMaxUse="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="unsafe", symptoms=["No space left on device"])
def no_size_limit(robot: Robot) -> Iterator[Finding]:
    for daemon in robot.journald:
        storage = daemon.get("Storage", read=str)
        if storage is None or storage[1] != "persistent" or not storage[0].span.source.judged or not daemon.certain:
            continue
        if not daemon.sets("SystemMaxUse", "SystemKeepFree"):
            at = storage[0].span
            yield finding(
                storage[0],
                "Nothing limits the journal: it may take 10 % of the disk, up to 4 GiB",
                advice="add SystemMaxUse=, for example 500M",
                fix=fix("SystemMaxUse=500M", (at.source.span(at.end, at.end), "\nSystemMaxUse=500M"), safe=False),
            )
