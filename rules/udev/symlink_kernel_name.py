"""A link has a name that the kernel gives to devices.

## What it finds
`SYMLINK+="ttyUSB0"`, `SYMLINK+="video1"` or another name that the kernel gives to devices in the order in
which it finds them.

## Why it matters on a robot
As soon as the kernel creates a device with that name, udev refuses the link, and the driver opens another
device.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="ttyUSB9"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## When to ignore it
If a closed-source program can open only this name and the number is far above what the kernel will ever
reach, such as `ttyUSB99`.

## References
- udev(7), SYMLINK
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

_KERNEL_NAME = regex(r"/dev/(?:ttyUSB|ttyACM|video|hidraw|media|input/(?:js|event|mouse))\d+|/dev/sd[a-z]\d*")


@rule("error", symptoms=["conflicting device node", "Not replacing existing device node"])
def symlink_kernel_name(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.matching:
        for link in line.links:
            if _KERNEL_NAME.fullmatch(link.path):
                yield finding(
                    link.name,
                    f"The kernel uses the name {link.path} itself: the link collides with the next device that gets it",
                    advice="use your own folder, such as robot/",
                )
