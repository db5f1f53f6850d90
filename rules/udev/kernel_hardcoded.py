"""A rule identifies its device by a number that can change.

## What it finds
`KERNEL=="ttyUSB0"`, `KERNELS=="ttyACM1"` or `KERNEL=="video2"` in a rule that makes a link, sets a property
or starts something; and `ATTRS{busnum}` or `ATTRS{devnum}`, the numbers of a USB bus and of a device on it.

## Why it matters on a robot
The number follows the order in which devices are found. After a reboot or a reconnection the rule applies to
another device, or to none.

## Bad
```udev
KERNEL=="ttyUSB0", SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## When to ignore it
If the robot can have only one device of this kind, now and later, so that the number is always the same.

## References
- udev(7), ATTRS
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.udev import Token

_NUMBERED = regex(r"ttyUSB\d+|ttyACM\d+|video\d")
_OF_BUS = {"busnum": "bus number", "devnum": "device number"}
_IDENTIFIED = ("SYMLINK", "NAME", "ENV", "RUN", "ATTR")


@rule("warning", silent="udev gives the link to the device that has the number")
def kernel_hardcoded(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.matching:
        if not any(line.line.assignments(key) for key in _IDENTIFIED):
            continue
        for token in line.line.tokens:
            if token.operator == "==" and (what := _numbered(token)):
                yield finding(
                    token.value,
                    f"{what} follows the order of discovery: a reboot can swap devices",
                    advice="match the device by ATTRS{serial}, or its USB port by KERNELS",
                )


def _numbered(token: Token) -> str:
    """What is numbered in the order of discovery; empty for everything else."""
    if token.key in ("KERNEL", "KERNELS") and _NUMBERED.fullmatch(token.value):
        return f"The number in {token.value}"
    if token.key in ("ATTR", "ATTRS") and token.attribute in _OF_BUS and token.value.isdecimal():
        return f"The {_OF_BUS[token.attribute]} {token.value}"
    return ""
