"""A match on a device attribute is written as an assignment.

## What it finds
An assignment to `ATTR{idVendor}`, `ATTR{serial}`, `ATTR{index}` or another attribute that identifies a device
and cannot be written.

## Why it matters on a robot
udev treats it as a write to sysfs. The match is lost, so the rule fires for every device: any adapter gets
the link, and the last one keeps it. `udevadm verify` accepts the line.

## Bad
```udev
SUBSYSTEM=="usb", ATTR{idVendor}="0403", MODE="0660"
```

## Good
```udev
SUBSYSTEM=="usb", ATTR{idVendor}=="0403", MODE="0660"
```

## When to ignore it
If the driver of the matched device has a writable attribute with this name and the rule is meant to write it.

## References
- udev(7), ATTR
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
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


@rule("error", fix="unsafe", symptoms=["Failed to write", "Failed to write ATTR{*}=*, ignoring:"])
def attr_write_suspect(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for token in line.line.assignments("ATTR"):
            if token.attribute in _IDENTITY:
                yield finding(
                    token.operator,
                    f"{token.name}{token.operator} writes to sysfs instead of matching: the rule fires for any device",
                    advice="write == to match",
                    fix=fix("write ==", (token.operator, "==")),
                )
