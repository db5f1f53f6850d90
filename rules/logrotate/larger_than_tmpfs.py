"""The rotated logs do not fit in their tmpfs.

## What it finds
A stanza for files on a tmpfs of fstab that can need more room than the `size=` of the tmpfs. The need is
`size` or `minsize`, times the log and the rotated files that stay uncompressed. With `maxsize` alone, one
file counts. Trees with several fstab files are not checked.

## Why it matters on a robot
The tmpfs is full long before anything is rotated. Every log on the robot then fails with `No space left on
device`, just when something goes wrong and writes a lot.

## Bad
```
# fstab: tmpfs /var/log tmpfs size=64M,mode=0755 0 0
/var/log/rover.log {
    size 20M
    rotate 4
}
```

## Good
```
/var/log/rover.log {
    size 5M
    rotate 4
    compress
}
```

## When to ignore it
When the sizes are a safety margin that the logs never reach, for example because they are rotated hourly.

## References
- logrotate(8), "size", "rotate"
- tmpfs(5), "size"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.logrotate import Stanza

UNITS = {"": 1, "k": 1024, "m": 1024**2, "g": 1024**3}


@rule("warning", symptoms=["No space left on device"])
def larger_than_tmpfs(robot: Robot) -> Iterator[Finding]:
    fstab = robot.fstabs[0] if len(robot.fstabs) == 1 else None
    if not fstab:
        return
    for stanza in robot.logs.stanzas:
        limit = stanza.get("size", "minsize") or stanza.get("maxsize")
        mounts = [fstab.mount_of(path) for path in stanza.paths if robot.same_robot(path, fstab.source)]
        mount = next((each for each in mounts if each is not None and each.is_tmpfs and each.option("size")), None)
        size = mount.option("size") if mount is not None else None
        if limit is None or mount is None or size is None or stanza.skipped:
            continue
        each = amount(limit.value)
        room, files = amount(size), 1 + kept(stanza) if limit.name != "maxsize" else 1
        if room is not None and each is not None and files * each > room:
            what = f"{files} files of {limit.value} need" if files > 1 else f"A file of {limit.value} needs"
            yield finding(
                limit.value,
                f"{what} more than {size}, the size of the tmpfs on {mount.target}: it fills up first",
                advice="lower size and rotate, or compress",
                related=[note(size, f"the size of {mount.target}")],
            )


def kept(stanza: Stanza) -> int:
    """How many rotated files stay as large as they were."""
    rotate, compressed = stanza.get("rotate"), stanza.get("compress", "nocompress")
    if rotate is None or not rotate.value.isdecimal():
        return 0
    number = int(rotate.value)
    if compressed is not None and compressed.name == "compress":
        return min(number, 1) if stanza.get("delaycompress") else 0
    return number


def amount(text: str) -> int | None:
    match = re.fullmatch(r"(\d+)([kmg]?)", text.strip().lower())
    return int(match[1]) * UNITS[match[2]] if match else None
