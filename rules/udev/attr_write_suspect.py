"""A match on a device attribute is written as an assignment.

## What it finds
`ATTR{idVendor}=`, `ATTR{serial}=`, `ATTR{index}=` and other attributes that identify a device and cannot be
written, with a single equals sign.

## Why it matters on a robot
udev takes it for a write to sysfs. The match is lost, so the rule fires for every device: any adapter gets
the link, and the last one keeps it. `udevadm verify` accepts the line.

## Bad
```udev
SUBSYSTEM=="usb", ATTR{idVendor}="0403", MODE="0660"
```

## Good
```udev
SUBSYSTEM=="usb", ATTR{idVendor}=="0403", MODE="0660"
```

## References
- udev(7), ATTR
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

_IDENTITY = {
    "idVendor",
    "idProduct",
    "serial",
    "index",
    "name",
    "manufacturer",
    "product",
    "bInterfaceNumber",
    "address",
}


@rule("error", fix="safe", symptoms=["Failed to write"])
def attr_write_suspect(robot: Robot):
    for line in robot.udev.judged:
        for token in line.line.assignments("ATTR"):
            if token.attribute in _IDENTITY:
                yield finding(
                    token.operator,
                    f"{token.name}{token.operator} writes to sysfs and matches nothing: any device will do",
                    advice="write == to match",
                    fix=fix("write ==", (token.operator, "==")),
                )
