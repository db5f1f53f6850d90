"""A link for a serial port or camera points to the raw USB node.

## What it finds
A rule for `SUBSYSTEM=="usb"` that makes a link for a device whose kernel driver provides ttyUSB, ttyACM or
video nodes.

## Why it matters on a robot
The link points to /dev/bus/usb/..., which a serial or camera driver cannot open. The driver reports 'port not
found' although the link exists.

## Bad
```udev
SUBSYSTEM=="usb", ATTR{idVendor}=="0403", ATTR{idProduct}=="6014", SYMLINK+="robot/arm"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{idProduct}=="6014", SYMLINK+="robot/arm"
```

## When to ignore it
If a program opens the raw USB device through libusb, for example a firmware updater or a camera SDK.

## References
- https://github.com/ROBOTIS-GIT/dynamixel-workbench/issues/177
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.udev import UdevRule

_NODES = {"ttyUSB": "tty", "ttyACM": "tty", "video": "video4linux"}


@rule("warning", silent="udev makes the link as it is told")
def usb_subsystem_device_node(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        device = line.usb_device
        subsystem = _NODES.get(device["device"]) if device else None
        if device is None or subsystem is None or not _is_for_usb_nodes(line):
            continue
        product = device["product"]
        for link in line.links:
            yield finding(
                link.name,
                f"{link.path} points to the raw USB node of the {product}: its driver cannot open it",
                advice=f'match SUBSYSTEM=="{subsystem}" and use ATTRS for the numbers',
            )


def _is_for_usb_nodes(line: UdevRule) -> bool:
    types = [condition for condition in line.on("ENV", "DEVTYPE") if condition.equal]
    return line.is_for("usb") or any(condition.accepts("usb_device") for condition in types)
