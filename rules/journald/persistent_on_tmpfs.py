"""A persistent journal on a tmpfs is lost at power-off.

## What it finds
fstab mounts a tmpfs on /var/log or /var/log/journal, and journald writes there:

- error: with `Storage=persistent`;
- warning: when SystemMaxUse is at least the size of the tmpfs.

## Why it matters on a robot
The journal is in memory: the log of the failure is lost with the power. A journal that may outgrow its file
system leaves no room for the other logs.

## Bad
```ini
# journald.conf
[Journal]
Storage=persistent
SystemMaxUse=1G
# fstab
# tmpfs /var/log tmpfs size=128M,mode=0755 0 0
```

## Good
```ini
[Journal]
Storage=volatile
RuntimeMaxUse=64M
```

## When to ignore it
When the journal is also sent to another machine, for example by systemd-journal-upload, and losing the local
copy is acceptable.

## References
- journald.conf(5), "Storage="
- tmpfs(5), "size"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Data from the specified boot (-1) is not available: No such boot ID in journal"])
def persistent_on_tmpfs(robot: Robot) -> Iterator[Finding]:
    if len(robot.fstabs) != 1 or len(robot.journald) != 1:
        return
    (fstab,), (daemon,) = robot.fstabs, robot.journald
    mount = fstab.mount_of("/var/log/journal")
    if mount is None or not mount.is_tmpfs or not daemon.certain:
        return
    if not robot.same_robot(fstab.source, daemon.files[0].source):
        return
    storage = daemon.get("Storage", read=str)
    use, size = daemon.get("SystemMaxUse", read=bytes_of), mount.option("size")
    room = bytes_of(size.upper()) if size else None
    excess = use[0] if use is not None and room is not None and use[1] >= room else None
    if storage is not None and storage[1] == "persistent":
        yield finding(
            storage[0],
            "The journal is on a tmpfs: it is lost at power-off"
            + (f", and {excess} does not fit in {size}" if excess else ""),
            advice="mount a data partition on /var/log/journal, or set Storage=volatile",
            related=[note(mount.place, f"a tmpfs is mounted on {mount.place}")],
        )
    elif excess is not None and size is not None:
        yield finding(
            excess,
            f"The journal may grow to {excess}, but the tmpfs that holds it has only {size}",
            advice="set SystemMaxUse= to at most half of the tmpfs",
            related=[note(size, "the size of the tmpfs")],
            severity="warning",
        )


def bytes_of(text: str) -> int | None:
    number, unit = text[:-1] if text[-1:] in "KMGT" else text, text[-1:]
    return int(number) * 1024 ** ("KMGT".find(unit) + 1 if unit in "KMGT" else 0) if number.isdecimal() else None
