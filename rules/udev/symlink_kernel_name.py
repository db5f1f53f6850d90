"""A link has the name of a kernel device.

## What it finds
`SYMLINK+="ttyUSB0"`, `"video1"` or another name that the kernel gives to devices in the order in which it
finds them.

## Why it matters on a robot
As soon as the kernel makes a node of that name, udev refuses the link, and the driver opens another device.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="ttyUSB9"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## References
- udev(7), SYMLINK
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_KERNEL_NAME = re.compile(r"/dev/(?:ttyUSB|ttyACM|video|hidraw|media|input/(?:js|event|mouse))\d+|/dev/sd[a-z]\d*")


@rule("error", symptoms=["conflicting device node", "Not replacing existing device node"])
def symlink_kernel_name(robot: Robot):
    for line in robot.udev.judged:
        for link in line.links:
            if _KERNEL_NAME.fullmatch(link.path):
                yield finding(
                    link.name,
                    f"The kernel makes nodes called {link.path} itself: the link collides with the next one",
                    advice="use a folder of your own, such as robot/",
                )
