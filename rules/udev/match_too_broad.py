"""A rule gives one link to every device of a kind.

## What it finds
A rule that makes a link and matches nothing that distinguishes one device from another: only `SUBSYSTEM`,
`ACTION` or a kernel name such as `ttyUSB*`. With a kernel name the finding is a warning, because one port of
that kind may be all the robot has.

## Why it matters on a robot
Each device that appears takes the link from the one before. The driver opens whichever device came last: the
base instead of the LiDAR.

## Bad
```udev
SUBSYSTEM=="tty", SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## When to ignore it
If the computer will never have more than one device of this kind, and the link is only a friendlier name for
it.

## References
- udev(7), SYMLINK and "link_priority="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_MANY = (
    "tty",
    "video4linux",
    "usb",
    "input",
    "hidraw",
    "block",
    "i2c-dev",
    "spidev",
    "gpio",
    "sound",
    "media",
    "iio",
    "drm",
)
_BROAD = {
    ("SUBSYSTEM", ""),
    ("SUBSYSTEMS", ""),
    ("ACTION", ""),
    ("ENV", "DEVTYPE"),
    ("ENV", "MAJOR"),
    ("KERNEL", ""),
}
OF_USB = "add ATTRS{idVendor}, ATTRS{idProduct} and ATTRS{serial}, or KERNELS for the port"
OF_INPUT = "add ATTRS{name}, or ATTRS{uniq} with the address of a Bluetooth device"
_DECIDING = ("PROGRAM", "IMPORT", "RESULT", "TEST", "OPTIONS", "GOTO")


@rule("error", symptoms=["appeared twice with different sysfs paths"])
def match_too_broad(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        if any(line.line.first(key) for key in _DECIDING) or not line.subjects <= _BROAD:
            continue
        if line.subsystems and not line.is_for(*_MANY):
            continue
        named = line.on("KERNEL")
        if named and not all(line.is_any_number(pattern) for one in named for pattern in one.patterns):
            continue
        what = (
            "device" if not line.subsystems else "/".join(line.kernels) or f"{'/'.join(sorted(line.subsystems))} device"
        )
        for link in line.links:
            if link.is_fixed:
                yield finding(
                    link.name,
                    f"Every {what} gets the link {link.path}: the last one keeps it",
                    advice=OF_INPUT if line.is_for("input") else OF_USB,
                    severity="warning" if named else None,
                )
