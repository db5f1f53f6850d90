"""A mount point appears twice in fstab.

## What it finds
Two lines with the same mount point. `none`, swap, overlays and lines with `noauto` are not counted.

## Why it matters on a robot
systemd creates one unit for each mount point and uses the first line. With `mount -a` the second file system covers
the first. Data seems to be gone, depending on what mounted it.

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

## When to ignore it
When the second mount is meant to cover the first and the boot does not use systemd.

## References
- systemd-fstab-generator(8)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.host import Mount


@rule("error", symptoms=["Duplicate entry in /etc/fstab?"])
def duplicate_mount(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        first: dict[str, Mount] = {}
        for mount in fstab.mounts:
            target = mount.target
            if target is None or not target.startswith("/") or mount.has("noauto") or mount.type in ("overlay", "swap"):
                continue
            other = first.setdefault(target.rstrip("/") or "/", mount)
            if other is not mount:
                yield finding(
                    target,
                    f"{target} is mounted twice: only the first line applies at boot",
                    advice="delete one of the lines",
                    related=[note(other.place, "the first line")],
                )
