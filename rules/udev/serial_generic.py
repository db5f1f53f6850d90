"""A serial number is shared by many devices of the same model.

## What it finds
A match on `ATTRS{serial}` or `ENV{ID_SERIAL_SHORT}` with a factory default such as `0001` or a placeholder
such as `123456789`, in a rule that does not match the USB port.

## Why it matters on a robot
CP2102 boards leave the factory with serial number 0001: a second LiDAR or servo adapter also matches and
takes the link.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="10c4", ATTRS{serial}=="0001", SYMLINK+="robot/lidar"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="10c4", KERNELS=="1-1.3", SYMLINK+="robot/lidar"
```

## When to ignore it
If the robot has only one adapter with this chip and will not get another.

## References
- udev(7), KERNELS
- Silicon Labs AN721: programming a serial number into a CP210x
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_PORT = {("KERNELS", ""), ("ENV", "ID_PATH"), ("ENV", "ID_PATH_TAG"), ("DEVPATH", "")}


@rule("warning", symptoms=["appeared twice with different sysfs paths"])
def serial_generic(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.matching:
        if line.subjects & _PORT:
            continue
        for condition in line.serials:
            common = [serial for serial in condition.patterns if robot.udev.is_factory_serial(serial)]
            if common and not condition.inherited:
                yield finding(
                    condition.token.value,
                    f"The serial number '{common[0]}' is a factory default: other adapters have it too",
                    advice="match the port with KERNELS or ENV{ID_PATH}, or program a serial number",
                )
