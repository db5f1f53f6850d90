"""No rate limit: one node can flood the journal.

## What it finds
`RateLimitBurst=0` or `RateLimitIntervalSec=0`.

## Why it matters on a robot
A node that logs in its control loop pushes everything else out of the journal within minutes, and wears the
flash.

## Bad
```ini
[Journal]
RateLimitBurst=0
```

## Good
```ini
[Journal]
RateLimitIntervalSec=30s
RateLimitBurst=50000
```

## References
- journald.conf(5), "RateLimitIntervalSec="
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info")
def ratelimit_off(robot: Robot):
    for daemon in robot.journald:
        for keys in (("RateLimitIntervalSec", "RateLimitInterval"), ("RateLimitBurst",)):
            found = daemon.get(*keys, read=daemons.watchdog_seconds)
            if found is not None and found[1] == 0 and found[0].span.source.judged:
                yield finding(
                    found[0],
                    "There is no rate limit: a flooding node fills the journal",
                    advice="set a high limit instead",
                )
