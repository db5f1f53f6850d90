"""A rules file sorts before the packaged file that it needs.

## What it finds
A match on a property such as `ENV{ID_PATH}` or `ENV{ID_SERIAL_SHORT}` in a file that is read before the
packaged file which imports it, and `GROUP` or `MODE` in a file that is read before the one which sets it
anew. Files are read in the order of their names, whatever folder they lie in.

## Why it matters on a robot
The property is still empty, so the rule never fires; the permission is set and then overwritten, so the
driver gets 'permission denied'.

## Bad
```udev
# 10-robot.rules
SUBSYSTEM=="tty", ENV{ID_PATH}=="pci-*-usb-0:1.2:1.0", SYMLINK+="robot/imu"
```

## Good
```udev
# 99-robot.rules
SUBSYSTEM=="tty", ENV{ID_PATH}=="pci-*-usb-0:1.2:1.0", SYMLINK+="robot/imu"
```

## References
- udev(7), "Rules Files"
- https://github.com/odriverobotics/ODrive/issues/241
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def file_order(robot: Robot):
    for line, early in robot.udev.too_early:
        name = line.source.basename
        if early.value:
            message = f"{early.file} is read after {name} and sets {early.token.key} to {early.value} again"
        else:
            message = f"{early.token.attribute} is still empty in {name}, {early.file} sets it: this never fires"
        advice = f"rename the file so that it sorts after {early.file}, such as 99-robot.rules"
        yield finding(early.token.span, message, advice=advice)
