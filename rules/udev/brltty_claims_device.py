"""The driver for braille displays claims a robot's USB adapter.

## What it finds
A rule for a USB serial adapter that brltty also claims:
- **error**: the brltty rules of the tree claim the id without further conditions.
- **info**: the repository targets Ubuntu 22.04, whose brltty claims the id.

## Why it matters on a robot
brltty takes every CH340 adapter for a braille display: ttyUSB0 appears and vanishes a moment later, and the
motor controller is gone.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="1a86", ATTRS{idProduct}=="7523", KERNELS=="1-1.4", SYMLINK+="robot/base"
```

## Good
```udev
# /etc/udev/rules.d/85-brltty.rules is a link to /dev/null
SUBSYSTEM=="tty", ATTRS{idVendor}=="1a86", ATTRS{idProduct}=="7523", KERNELS=="1-1.4", SYMLINK+="robot/base"
```

## When to ignore it
If brltty is removed from the image by a step that the linter does not see, such as an installation script run
by hand.

## References
- https://github.com/huggingface/lerobot/issues/497
- https://github.com/ArduPilot/ardupilot/pull/20677
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["brltty", "interface 0 claimed by ch341 while 'brltty' sets config #1"])
def brltty_claims_device(robot: Robot) -> Iterator[Finding]:
    jammy = robot.target.systemd_known and robot.target.systemd == 249 and not robot.tree.complete
    for line in robot.udev.judged:
        if not line.is_serial:
            continue
        for usb_id in line.usb_ids:
            claim = robot.udev.brltty_claim(line, usb_id)
            where = line.usb_number
            if claim is not None:
                yield finding(
                    where,
                    f"brltty claims the adapter {usb_id}: its ttyUSB appears and vanishes",
                    advice=f"mask {claim.source.basename} in /etc/udev/rules.d, or remove brltty",
                    related=[note(claim.span, "claims the adapter here")],
                    severity="error",
                )
            elif jammy and robot.udev.is_claimed_on_jammy(usb_id):
                yield finding(
                    where,
                    f"brltty of Ubuntu 22.04 claims the adapter {usb_id}: its ttyUSB appears and vanishes",
                    advice="mask 85-brltty.rules in /etc/udev/rules.d, or remove brltty",
                    severity="info",
                )
