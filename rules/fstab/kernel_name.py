"""A disk is named by the kernel.

## What it finds
`/dev/sdX` as the device of a mount. eMMC and NVMe names are mostly stable.

## Why it matters on a robot
With a second disk or stick plugged in at boot, sda is sdb: the wrong file system is mounted, or the boot
waits for one that does not come.

## Bad
```
/dev/sda1 /data ext4 defaults,nofail 0 2
```

## Good
```
UUID=… /data ext4 defaults,nofail 0 2
```

## References
- fstab(5)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

KERNEL_NAME = re.compile(r"/dev/[sh]d[a-z]\d*")


@rule("info")
def kernel_name(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            if KERNEL_NAME.fullmatch(mount.device):
                yield finding(
                    mount.device,
                    f"{mount.device} may be another disk after the next boot",
                    advice="name it by UUID= or LABEL=",
                )
