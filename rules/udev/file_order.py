"""A rules file sorts before the packaged file that it needs.

## What it finds
Two mistakes in the order of files, which udev reads in the order of their names, whatever folder they are in:
- A match on a property such as `ENV{ID_PATH}` or `ENV{ID_SERIAL_SHORT}` in a file that is read before the
  packaged file that imports the property.
- `GROUP` or `MODE` in a file that is read before the packaged file that sets it to another value.

## Why it matters on a robot
In the first case the property is still empty, so the rule never fires. In the second case the packaged file
overwrites the permission, so the driver gets 'permission denied'.

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

## When to ignore it
If the packaged file is masked or removed on the robot, or a rule that the linter does not see imports the
property earlier.

## References
- udev(7), "Rules Files"
- https://github.com/odriverobotics/ODrive/issues/241
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def file_order(robot: Robot) -> Iterator[Finding]:
    for line, early in robot.udev.too_early:
        name = line.source.basename
        if early.value:
            whose = " of the USB device node" * line.is_for_usb_nodes
            message = f"{early.file} is read after {name} and overwrites {early.token.key}{whose} with {early.value}"
        else:
            message = f"{early.token.attribute} is empty in {name}, {early.file} sets it later: the rule never fires"
        advice = f"rename the file so that it sorts after {early.file}, such as 99-robot.rules"
        yield finding(early.token.span, message, advice=advice, confidence="medium" if line.is_for_usb_nodes else None)
