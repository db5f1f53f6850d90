"""The watchdog daemon feeds the watchdog too late: the robot reboots.

## What it finds
watchdog.conf sets `interval` too large for watchdog-timeout (60 s by default):

- error: interval is at least the timeout;
- warning: interval is more than half of the timeout.

## Why it matters on a robot
The hardware resets the robot before the daemon feeds the watchdog, again and again.

## Bad
```ini
watchdog-device = /dev/watchdog
watchdog-timeout = 10
interval = 15
```

## Good
```ini
watchdog-device = /dev/watchdog
watchdog-timeout = 10
interval = 2
```

## When to ignore it
The warning, when the hardware enforces a longer timeout than watchdog.conf sets. Never ignore the error.

## References
- watchdog.conf(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

DEFAULT_TIMEOUT = 60


@rule(
    "error",
    symptoms=[
        "This interval length (*) might reboot the system while the process sleeps! Try * or less",
        "watchdog now set to * seconds, should be more than double interval",
    ],
)
def watchdog_timeout_vs_interval(robot: Robot) -> Iterator[Finding]:
    for settings in robot.watchdog.settings:
        interval, timeout = settings.get("interval"), settings.get("watchdog-timeout")
        if interval is None or not interval.isdecimal() or (timeout is not None and not timeout.isdecimal()):
            continue
        if "watchdog-device" not in settings or not interval.span.source.judged:
            continue
        most = int(timeout) if timeout is not None else DEFAULT_TIMEOUT
        if int(interval) * 2 > most:
            late = int(interval) >= most
            yield finding(
                interval,
                f"The daemon feeds the watchdog every {interval} s, and the watchdog resets after {most} s"
                + ("" if late else ": one late cycle reboots the robot"),
                advice=f"set interval = {max(most // 4, 1)}",
                related=[note(timeout, "the watchdog's timeout")] if timeout is not None else (),
                severity=None if late else "warning",
            )
