"""The uaccess tag comes after the file that evaluates it.

## What it finds
`TAG+="uaccess"` in a file that sorts after `73-seat-late.rules`, in a rule that gives no other permission.

## Why it matters on a robot
73-seat-late.rules gives the logged-in user access to tagged devices. A later tag is never looked at:
permission denied for everybody but root.

## Bad
```udev
# 99-robot.rules
SUBSYSTEM=="hidraw", ATTRS{idVendor}=="1209", TAG+="uaccess"
```

## Good
```udev
# 70-robot.rules
SUBSYSTEM=="hidraw", ATTRS{idVendor}=="1209", TAG+="uaccess"
```

## References
- https://github.com/libusb/hidapi/issues/326
- https://github.com/raspberrypi/picotool/issues/199
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def uaccess_too_late(robot: Robot):
    for line in robot.udev.judged:
        if line.source.basename <= "73-seat-late.rules" or line.line.first("MODE") or line.line.first("GROUP"):
            continue
        for token in line.line.assignments("TAG"):
            if token.value == "uaccess" and token.operator != "-=":
                yield finding(
                    token.span,
                    f"73-seat-late.rules looks for this tag before {line.source.basename} is read: no access",
                    advice="move the rule to a file such as 70-robot.rules, or use GROUP and MODE",
                )
