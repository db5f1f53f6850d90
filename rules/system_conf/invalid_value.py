"""A value that systemd cannot read: the line is ignored.

## What it finds
A value in [Manager] of system.conf or a drop-in that does not follow the grammar of its key.

## Why it matters on a robot
The hardware watchdog stays off, or the default timeouts stay as they are; only one line in the journal tells.

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

## References
- systemd-system.conf(5), systemd.syntax(7), systemd.time(7)
- journal: "Failed to parse ... value, ignoring"
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemon_rules
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Failed to parse", "ignoring:"])
def invalid_value(robot: Robot):
    yield from daemon_rules.invalid_values(robot.system_conf, robot.target)
