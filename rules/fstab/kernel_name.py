"""A mount uses a kernel device name that can change.

## What it finds
`/dev/sdX` or `/dev/hdX` as the device of a mount. eMMC and NVMe names are mostly stable and not reported.

## Why it matters on a robot
If a second disk or stick is plugged in at boot, sda may become sdb: the wrong file system is mounted, or the boot
waits for one that does not appear.

## Bad
```
/dev/sda1 /data ext4 defaults,nofail 0 2
```

## Good
```
UUID=… /data ext4 defaults,nofail 0 2
```

## When to ignore it
When the board has exactly one disk port and no USB.

## References
- fstab(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

KERNEL_NAME = regex(r"/dev/[sh]d[a-z]\d*")


@rule(
    "info",
    symptoms=[
        "Timed out waiting for device /dev/sd",
        "Timed out waiting for device dev-sd",
        "special device /dev/sd* does not exist",
    ],
)
def kernel_name(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            if KERNEL_NAME.fullmatch(mount.device):
                yield finding(
                    mount.device,
                    f"{mount.device} may be another disk after the next boot",
                    advice="use UUID= or LABEL=",
                )
