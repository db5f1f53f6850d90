r"""A link depends on vendor and product number only.

## What it finds
A rule for a serial port or camera that makes a link and knows the device by `idVendor` and `idProduct` alone.
A warning for bridge chips that sit in many products (FTDI, CP210x, CH340, PL2303, STM32, Arduino), for
information otherwise.

## Why it matters on a robot
A second adapter with the same chip matches too and takes the link: IMU and motor controller change places
from one boot to the next.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{idProduct}=="6001", SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{idProduct}=="6001", ATTRS{serial}=="A5XK3RJT", \
  SYMLINK+="robot/imu"
```

## References
- udev(7), ATTRS and KERNELS
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_WEAK = {
    ("SUBSYSTEM", ""),
    ("SUBSYSTEMS", ""),
    ("ACTION", ""),
    ("KERNEL", ""),
    ("DRIVERS", ""),
    ("ATTRS", "idVendor"),
    ("ATTRS", "idProduct"),
    ("ATTR", "index"),
    ("ENV", "ID_V4L_CAPABILITIES"),
    ("ENV", "MAJOR"),
    ("ENV", "DEVTYPE"),
    ("ENV", "ID_BUS"),
}
_DECIDING = ("PROGRAM", "IMPORT", "RESULT", "TEST")


@rule("warning")
def symlink_vidpid_only(robot: Robot):
    for line in robot.udev.judged:
        if not line.usb_ids or not (line.is_serial or line.is_for("video4linux")):
            continue
        if not line.subjects <= _WEAK or any(line.line.first(key) for key in _DECIDING):
            continue
        products = line.generic_products
        what = (
            f"Every {products[0]} matches" if products else f"A second device {' or '.join(line.usb_ids)} matches too"
        )
        for link in line.links:
            if link.is_fixed:
                yield finding(
                    link.name,
                    f"{what}: {link.path} goes to whichever was found last",
                    advice="add ATTRS{serial}, or KERNELS or ENV{ID_PATH} for the port",
                    severity=None if products else "info",
                )
