"""A rule for the removal of a device asks for its attributes.

## What it finds
A rule with `ACTION=="remove"` that matches what a USB device says of itself, `ATTR{}` or `ATTRS{}` of idVendor,
idProduct, serial, manufacturer, product or bcdDevice.

## Why it matters on a robot
When udev gets the event, the device is gone from sysfs, and no attribute can be read: the rule never fires. What should
stop the driver, or tell the robot that its lidar is lost, does not happen.

## Bad
```udev
ACTION=="remove", SUBSYSTEM=="tty", ATTRS{idVendor}=="10c4", RUN+="/bin/systemctl --no-block stop lidar.service"
```

## Good
```udev
ACTION=="remove", SUBSYSTEM=="tty", ENV{ID_VENDOR_ID}=="10c4", RUN+="/bin/systemctl --no-block stop lidar.service"
```

## When to ignore it
When the attribute is that of a hub or an adapter that stays.

## References
- udev(7): ATTRS are searched in sysfs; the properties of the udev database are kept for the event
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

OF_DEVICE = {
    "idVendor": "ENV{ID_VENDOR_ID}",
    "idProduct": "ENV{ID_MODEL_ID}",
    "serial": "ENV{ID_SERIAL_SHORT}",
    "manufacturer": "ENV{ID_VENDOR}",
    "product": "ENV{ID_MODEL}",
    "bcdDevice": "ENV{ID_REVISION}",
}
"""Attributes of USB devices -> the properties that udev keeps of them."""


@rule("warning", confidence="medium", silent="udev goes on to the next rule without a message")
def remove_attrs(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        actions = line.line.matches("ACTION")
        if not any(token.operator == "==" and token.value == "remove" for token in actions):
            continue
        asked = (token for key in ("ATTR", "ATTRS") for token in line.line.matches(key))
        token = next((each for each in asked if each.operator == "==" and str(each.attribute) in OF_DEVICE), None)
        if token is not None:
            yield finding(
                token.span,
                f"No {token.name} can be read when the device is gone: this rule never fires",
                advice=f"match {OF_DEVICE[str(token.attribute)]}, as udevadm info shows it",
            )
