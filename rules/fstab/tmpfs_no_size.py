"""A tmpfs can use half of the memory.

## What it finds
A tmpfs without `size=` or `nr_blocks=`. `/dev/shm` and `/run` belong to systemd and are not reported.

## Why it matters on a robot
Logs or bags in a tmpfs without a limit drive the robot into the out-of-memory killer.

## Bad
```
tmpfs /tmp tmpfs defaults 0 0
```

## Good
```
tmpfs /tmp tmpfs size=128M 0 0
```

## When to ignore it
When half of the memory is acceptable, because the robot has much more than its nodes need.

## References
- tmpfs(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="the mount works; what runs out of memory later is another program")
def tmpfs_no_size(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            if mount.is_tmpfs and not mount.has("size", "nr_blocks") and mount.place not in ("/dev/shm", "/run"):
                yield finding(
                    mount.place,
                    f"The tmpfs on {mount.place} can use half of the memory",
                    advice="add size=128M, or the size that you need",
                )
