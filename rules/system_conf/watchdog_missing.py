"""No hardware watchdog: nothing restarts the robot when the kernel hangs.

## What it finds
A complete root file system with ROS where RuntimeWatchdogSec is not set and no other program opens
/dev/watchdog.

## Why it matters on a robot
When the kernel or systemd hangs, nothing restarts the computer. The motors keep their last command until
someone intervenes.

## Bad
```ini
[Manager]
#RuntimeWatchdogSec=off
```

## Good
```ini
[Manager]
RuntimeWatchdogSec=14s
```

## When to ignore it
When the computer has no hardware watchdog, or when a safety controller outside of the computer cuts the
power.

## References
- systemd-system.conf(5), "RuntimeWatchdogSec="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="a kernel that hangs writes no log")
def watchdog_missing(robot: Robot) -> Iterator[Finding]:
    if not robot.tree.complete or not robot.is_ros or robot.watchdog.owners:
        return
    for daemon in robot.system_conf:
        meant = any(key == "RuntimeWatchdogSec" and value not in ("0", "off") for *_, key, value in daemon.commented())
        if daemon.judged and not meant and not daemon.sets("RuntimeWatchdogSec"):
            yield finding(
                daemon.where,
                "Nothing restarts the robot when the kernel or systemd hangs",
                advice="set RuntimeWatchdogSec= to a value that the hardware timer supports",
            )
