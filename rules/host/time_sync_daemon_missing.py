"""No time daemon is enabled on the robot.

## What it finds
A whole root file system in which none of chrony, systemd-timesyncd, ntpsec, ntpd, openntpd, ptp4l, phc2sys and
timemaster is enabled.

## Why it matters on a robot
The clocks of the robot's computers drift apart: TF drops transforms from the future, bags cannot be merged, and
certificates seem invalid.

## Bad
```
/etc/systemd/system/multi-user.target.wants/         (no chrony.service)
```

## Good
```
systemctl enable chrony
```

## When to ignore it
When the robot has one computer without a network, or when a container or a receiver's own program sets the clock.

## References
- systemd-timesyncd.service(8)
- chronyd(8)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

DAEMONS = (
    "chrony",
    "chronyd",
    "systemd-timesyncd",
    "ntpsec",
    "ntp",
    "ntpd",
    "openntpd",
    "ptp4l",
    "phc2sys",
    "timemaster",
)
TARGETS = ("multi-user", "sysinit", "default", "graphical", "basic", "network-online")


@rule("warning", symptoms=["System clock synchronized: no"])
def time_sync_daemon_missing(robot: Robot) -> Iterator[Finding]:
    releases = [source for source in robot.of_kind("os-release") if source.judged]
    if not robot.tree.complete or not releases:
        return
    folders = [
        f"{top}/systemd/system/{target}.target.wants" for top in ("/etc", "/usr/lib", "/lib") for target in TARGETS
    ]
    used = [folder for folder in folders if robot.tree.has(folder)]
    units = [f"{folder}/{daemon}{suffix}.service" for folder in used for daemon in DAEMONS for suffix in ("", "@eth0")]
    if robot.tree.has("/etc/systemd/system") and not any(robot.tree.has(unit) for unit in units):
        if any(unit.name.partition(".")[0].partition("@")[0] in DAEMONS for unit in robot.units.judged):
            return
        yield finding(
            releases[0],
            "No time daemon is enabled: the clocks of the robot's computers drift apart",
            advice="systemctl enable chrony",
        )
