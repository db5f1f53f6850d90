"""Two owners of one watchdog: the second cannot open it.

## What it finds
RuntimeWatchdogSec switched on together with watchdog-device in watchdog.conf, or with a script or program
of the tree that opens /dev/watchdog.

## Why it matters on a robot
The kernel gives the device to one process. systemd takes it first; the daemon or the node gets EBUSY and
ends, or goes on without a watchdog.

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

## References
- systemd-system.conf(5), "WatchdogDevice="
- Linux kernel documentation, "The Linux Watchdog driver API"
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["cannot open /dev/watchdog (errno = 16 = 'Device or resource busy')"])
def watchdog_device_contention(robot: Robot):
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
                    f"systemd has {owner} already: {what} gets EBUSY",
                    advice="keep one owner: remove RuntimeWatchdogSec=, or this one",
                    related=[note(runtime[0], "systemd opens the watchdog")],
                )
