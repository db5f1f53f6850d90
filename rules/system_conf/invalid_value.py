"""A value that systemd cannot parse: it ignores the line.

## What it finds
A value in [Manager] of system.conf or a drop-in that does not follow the grammar of its key.

## Why it matters on a robot
The hardware watchdog stays off, or the default timeouts do not change. Only one line in the journal says so.

## Bad
```ini
[Manager]
DefaultTimeoutStopSec=20sek
```

## Good
```ini
[Manager]
DefaultTimeoutStopSec=20s
```

## When to ignore it
Never: systemd ignores the line, so that it has no effect. Correct or delete it.

## References
- systemd-system.conf(5), systemd.syntax(7), systemd.time(7)
- journal: "Failed to parse ... value, ignoring"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Failed to parse", "ignoring:"])
def invalid_value(robot: Robot) -> Iterator[Finding]:
    yield from daemons.invalid_values(robot.system_conf, robot.target)
