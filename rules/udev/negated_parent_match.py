"""A negated match on a USB parent is always true.

## What it finds
`ATTRS{idVendor}!=`, `ATTRS{idProduct}!=` or `ATTRS{serial}!=` in a rule without other parent keys. `ATTRS` is
satisfied by any device of the chain, and the root hub (vendor 1d6b) is a parent of every USB device.

## Why it matters on a robot
In a guard with `GOTO`, the rule jumps for every USB device, including the wanted one: none of the rules that
it skips ever fires.

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

## When to ignore it
Never as a guard, because the comparison does not exclude anything. If the line is meant for every USB device,
delete the match instead.

## References
- udev(7), ATTRS: "Search the devpath upwards for a device with matching sysfs attribute values"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_OF_ROOT_HUB = {"idVendor": "1d6b", "idProduct": "0002", "serial": "0000:00:14.0"}


@rule("error", silent="a match that succeeds is not reported")
def negated_parent_match(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        parents = line.parent_conditions
        if any(one.equal or not one.token.value or one.attribute not in _OF_ROOT_HUB for one in parents):
            continue
        if all(one.accepts(_OF_ROOT_HUB[one.attribute]) for one in parents):
            for one in parents[:1]:
                yield finding(
                    one.token.span,
                    f"{one.text} is true for every USB device, because the root hub is a parent of each",
                    advice="match the wanted device with ==, or negate a property such as ENV{ID_VENDOR_ID}",
                )
