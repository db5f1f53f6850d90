"""One mount point stands twice in fstab.

## What it finds
Two lines with the same mount point. `none`, swap, overlays and lines with `noauto` do not count.

## Why it matters on a robot
systemd makes one unit for a mount point and takes the first line; with `mount -a` the second lies over the
first. Data seems to be gone, depending on who mounted.

## Bad
```
UUID=a /data ext4 …
UUID=b /data ext4 …
```

## Good
```
UUID=a /data ext4 …
UUID=b /maps ext4 …
```

## References
- systemd-fstab-generator(8)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Duplicate entry in /etc/fstab?"])
def duplicate_mount(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        first = {}
        for mount in fstab.mounts:
            target = mount.target
            if target is None or not target.startswith("/") or mount.has("noauto") or mount.type in ("overlay", "swap"):
                continue
            other = first.setdefault(target.rstrip("/") or "/", mount)
            if other is not mount:
                yield finding(
                    target,
                    f"{target} is mounted twice: only the first line counts at boot",
                    advice="delete one of the lines",
                    related=[note(other.target, "first written here")],
                )
