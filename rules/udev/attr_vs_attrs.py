"""A rule looks for an attribute of the USB device on the port itself.

## What it finds
`ATTR{idVendor}`, `ATTR{idProduct}`, `ATTR{serial}` or another attribute of a USB device in a rule for tty,
video4linux, input or hidraw devices.

## Why it matters on a robot
`ATTR` looks only at the matched device, but the attribute belongs to its USB parent. The rule never fires.

## Bad
```udev
SUBSYSTEM=="tty", ATTR{idVendor}=="0403", ATTR{idProduct}=="6001", SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{idProduct}=="6001", SYMLINK+="robot/imu"
```

## When to ignore it
Only if a driver of your own adds an attribute of this name to the port itself; `udevadm info
--attribute-walk` then lists it in the first block.

## References
- udev(7), ATTR and ATTRS
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

_OF_USB_DEVICE = {
    "idVendor",
    "idProduct",
    "serial",
    "manufacturer",
    "product",
    "bcdDevice",
    "bInterfaceNumber",
}


@rule("error", fix="unsafe", silent="a match that fails is not reported")
def attr_vs_attrs(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        if not line.is_for("tty", "video4linux", "input", "hidraw"):
            continue
        for token in line.line.matches("ATTR"):
            if token.attribute in _OF_USB_DEVICE:
                subsystem = "/".join(sorted(line.subsystems))
                yield finding(
                    token.key,
                    f"A {subsystem} device has no {token.attribute}, only its USB parent has one: the rule never fires",
                    advice=f"write ATTRS{{{token.attribute}}}",
                    fix=fix("look at the parents", (token.key, "ATTRS")),
                )
