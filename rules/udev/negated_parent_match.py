"""A negated match on a USB parent is always true.

## What it finds
`ATTRS{idVendor}!=`, `ATTRS{idProduct}!=` or `ATTRS{serial}!=` in a rule without another parent key. `ATTRS`
looks for any device of the chain that fulfils it, and the root hub (vendor 1d6b) is a parent of every USB
device.

## Why it matters on a robot
As a guard with `GOTO` it jumps for every USB device, the wanted one included: none of the rules below it ever
fires.

## Bad
```udev
ATTRS{idVendor}!="0403", GOTO="robot_end"
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
LABEL="robot_end"
```

## Good
```udev
SUBSYSTEM!="tty", GOTO="robot_end"
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
LABEL="robot_end"
```

## References
- udev(7), ATTRS: "Search the devpath upwards for a device with matching sysfs attribute values"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_OF_ROOT_HUB = {"idVendor": "1d6b", "idProduct": "0002", "serial": "0000:00:14.0"}


@rule("error")
def negated_parent_match(robot: Robot):
    for line in robot.udev.judged:
        parents = line.parent_conditions
        if any(one.equal or not one.token.value or one.attribute not in _OF_ROOT_HUB for one in parents):
            continue
        if all(one.accepts(_OF_ROOT_HUB[one.attribute]) for one in parents):
            for one in parents[:1]:
                yield finding(
                    one.token.span,
                    f"Every USB device fulfils {one.text}: the root hub is a parent of each",
                    advice="match with == what is wanted, or negate a property such as ENV{ID_VENDOR_ID}",
                )
