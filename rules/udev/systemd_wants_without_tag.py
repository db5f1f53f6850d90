"""A rule starts a unit for a device that systemd does not track.

## What it finds
`ENV{SYSTEMD_WANTS}` or `ENV{SYSTEMD_USER_WANTS}` without `TAG+="systemd"` for a subsystem that
99-systemd.rules does not tag: video4linux, usb, hidraw, input, i2c-dev, spidev, gpio and others.

## Why it matters on a robot
Only tagged devices become device units. Without the tag the service never starts, and nothing is logged.

## Bad
```udev
SUBSYSTEM=="video4linux", ATTRS{serial}=="C1", ENV{SYSTEMD_WANTS}+="camera.service"
```

## Good
```udev
SUBSYSTEM=="video4linux", ATTRS{serial}=="C1", TAG+="systemd", ENV{SYSTEMD_WANTS}+="camera.service"
```

## When to ignore it
If a rules file outside the tree gives these devices the tag `systemd`.

## References
- systemd.device(5), "The udev Database"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", silent="systemd does not see the device, so nothing is started and nothing is reported")
def systemd_wants_without_tag(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        if line.is_tagged_by_systemd(robot.target.systemd) is not False:
            continue
        for token in line.line.assignments("ENV"):
            if token.attribute not in ("SYSTEMD_WANTS", "SYSTEMD_USER_WANTS") or not token.value:
                continue
            if not robot.udev.set_of(line).sets_beside(line, "TAG", "systemd"):
                subsystem = "/".join(sorted(line.subsystems))
                yield finding(
                    token.span,
                    f"systemd does not track {subsystem} devices: {token.value} never starts",
                    advice='add TAG+="systemd"',
                    fix=fix("tag the device", line.before(token, 'TAG+="systemd"')),
                )
