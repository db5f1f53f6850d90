r"""A link depends only on the vendor and product id.

## What it finds
A rule for a serial port or camera that makes a link and identifies the device by `idVendor` and `idProduct`
alone:
- **warning**: a bridge chip that is used in many products (FTDI, CP210x, CH340, PL2303, STM32, Arduino), on a robot
  with several serial devices: its rules make links to others, too, or its files name ports by their numbers; and any
  device whose link ends in the number of the kernel (`gps_%n`).
- **info**: any other device.

## Why it matters on a robot
A second adapter with the same chip also matches and takes the link: IMU and motor controller can swap from
one boot to the next.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{idProduct}=="6001", SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{idProduct}=="6001", ATTRS{serial}=="A5XK3RJT", \
  SYMLINK+="robot/imu"
```

## When to ignore it
If the robot carries exactly one device with this id, nobody plugs in another, and the link must also work for
a replacement device with a different serial number.

## References
- udev(7), ATTRS and KERNELS
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
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
NUMBERED = regex(r"(?:%n|\$number)$")
SERIAL = regex(r"/dev/tty(?:USB|ACM)\d+")
_DECIDING = ("PROGRAM", "IMPORT", "RESULT", "TEST")


@rule("warning", symptoms=["appeared twice with different sysfs paths"])
def symlink_vidpid_only(robot: Robot) -> Iterator[Finding]:
    has_several = _has_several(robot)
    for line in robot.udev.matching:
        if not line.usb_ids or not (line.is_serial or line.is_for("video4linux")):
            continue
        if not line.subjects <= _WEAK or any(line.line.first(key) for key in _DECIDING):
            continue
        products = line.generic_products
        what = (
            f"Every {products[0]} matches" if products else f"A second device {' or '.join(line.usb_ids)} matches too"
        )
        for link in line.links:
            if NUMBERED.search(link.name):
                yield finding(
                    link.name,
                    f"The number in {link.name} is that of the kernel, which counts devices in the order of discovery",
                    advice="match ATTRS{serial}, or the USB port, and give the link a fixed name",
                )
            elif link.is_fixed:
                yield finding(
                    link.name,
                    f"{what}: {link.path} points to the one found last",
                    advice="add ATTRS{serial}, or match the USB port with KERNELS or ENV{ID_PATH}",
                    severity=None if products and has_several else "info",
                )


def _has_several(robot: Robot) -> bool:
    """Whether the robot has more than one serial device or camera: links to others, or ports with numbers."""
    lines = (line for line in robot.udev.matching if line.is_serial or line.is_for("video4linux"))
    links = {link.path for line in lines for link in line.links}
    return len(links) > 1 or any(SERIAL.fullmatch(use.path) for use in robot.devices.uses)
