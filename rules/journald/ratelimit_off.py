"""Without a rate limit, one node can flood the journal.

## What it finds
`RateLimitBurst=0` or `RateLimitIntervalSec=0`.

## Why it matters on a robot
A node that logs in its control loop displaces all other messages from the journal within minutes, and wears
out the flash memory.

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

## When to ignore it
On a test bench or a development robot where no message may be dropped, as long as SystemMaxUse limits the
journal.

## References
- journald.conf(5), "RateLimitIntervalSec="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="journald stores everything that it gets")
def ratelimit_off(robot: Robot) -> Iterator[Finding]:
    for daemon in robot.journald:
        for keys in (("RateLimitIntervalSec", "RateLimitInterval"), ("RateLimitBurst",)):
            found = daemon.get(*keys, read=daemons.watchdog_seconds)
            if found is not None and found[1] == 0 and found[0].span.source.judged:
                yield finding(
                    found[0],
                    "The rate limit is off: one node that logs in a loop floods the journal",
                    advice="set a high limit instead",
                )
