"""A tmpfs may take half of the memory.

## What it finds
A tmpfs without `size=` or `nr_blocks=`. `/dev/shm` and `/run` belong to systemd.

## Why it matters on a robot
Logs or bags that run into a tmpfs without limit push the robot into its out-of-memory killer.

## Bad
```
tmpfs /tmp tmpfs defaults 0 0
```

## Good
```
tmpfs /tmp tmpfs size=128M 0 0
```

## References
- tmpfs(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info")
def tmpfs_no_size(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            if mount.is_tmpfs and not mount.has("size", "nr_blocks") and mount.target not in ("/dev/shm", "/run"):
                yield finding(
                    mount.target,
                    f"The tmpfs on {mount.target} may take half of the memory",
                    advice="add size=128M, or what it needs",
                )
