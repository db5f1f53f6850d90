"""The uaccess tag is set after the file that evaluates it.

## What it finds
`TAG+="uaccess"` in a file that sorts after `73-seat-late.rules`, in a rule that sets neither `MODE` nor
`GROUP`. Silent for a `static_node=`, whose tags logind reads from a file.

## Why it matters on a robot
73-seat-late.rules gives the logged-in user access to tagged devices as they appear. A tag that is set later counts at
the next login at the computer itself: until then, and over ssh, every user except root gets 'permission denied'.

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

## When to ignore it
If another rule gives the device its permissions, for example by `GROUP` and `MODE` in a vendor's file, and
the tag is left over.

## References
- systemd, src/login/logind-acl.c: at a login, all devices with the tag are opened to the user
- https://github.com/libusb/hidapi/issues/326
- https://github.com/raspberrypi/picotool/issues/199
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", silent="a tag that comes too late is not reported")
def uaccess_too_late(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        if line.source.basename <= "73-seat-late.rules" or line.line.first("MODE") or line.line.first("GROUP"):
            continue
        if any(token.value.startswith("static_node=") for token in line.line.assignments("OPTIONS")):
            continue
        for token in line.line.assignments("TAG"):
            if token.value == "uaccess" and token.operator != "-=":
                yield finding(
                    token.span,
                    f"73-seat-late.rules evaluates this tag before {line.source.basename} is read: who is logged in "
                    "when the device is plugged in gets no access",
                    advice="move the rule to a file such as 70-robot.rules, or use GROUP and MODE",
                )
