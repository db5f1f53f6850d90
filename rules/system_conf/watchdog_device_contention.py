"""Two programs open one watchdog device: the second one fails.

## What it finds
RuntimeWatchdogSec is on, and something else opens the same device: watchdog-device in watchdog.conf, or a
script or program in the tree.

## Why it matters on a robot
The kernel gives the device to one process. systemd opens it first. The daemon or node gets EBUSY, then exits
or continues without a watchdog.

## Bad
```ini
# system.conf
[Manager]
RuntimeWatchdogSec=20s
# watchdog.conf
# watchdog-device = /dev/watchdog
```

## Good
```ini
[Manager]
RuntimeWatchdogSec=20s
```

## When to ignore it
When the other program never runs while systemd feeds the watchdog, for example a test tool or a package that
is installed but disabled.

## References
- systemd-system.conf(5), "WatchdogDevice="
- Linux kernel documentation, "The Linux Watchdog driver API"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["cannot open /dev/watchdog (errno = 16 = 'Device or resource busy')"])
def watchdog_device_contention(robot: Robot) -> Iterator[Finding]:
    for daemon in robot.system_conf:
        runtime = daemon.get("RuntimeWatchdogSec", read=daemons.watchdog_seconds)
        if runtime is None or not runtime[1] or not daemon.certain:
            continue
        device = daemon.get("WatchdogDevice", read=str)
        name = (device[1] if device else "/dev/watchdog0").replace("/dev/watchdog0", "/dev/watchdog")
        for owner, what in robot.watchdog.owners:
            if str(owner).replace("/dev/watchdog0", "/dev/watchdog") == name and owner.span.source.judged:
                yield finding(
                    owner,
                    f"systemd already has {owner} open: {what} gets EBUSY",
                    advice="keep one of the two: remove RuntimeWatchdogSec=, or do not open the device here",
                    related=[note(runtime[0], "systemd opens the watchdog")],
                )
