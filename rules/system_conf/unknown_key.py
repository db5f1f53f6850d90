"""A key that systemd does not know: the line is ignored.

## What it finds
A key in [Manager] of system.conf or a drop-in that no release knows, and one that the robot's release does
not know yet.

## Why it matters on a robot
The hardware watchdog stays off, or the default timeouts stay as they are; only one line in the journal tells.

## Bad
```ini
[Manager]
RuntimeWatchDogSec=20s
```

## Good
```ini
[Manager]
RuntimeWatchdogSec=20s
```

## References
- systemd-system.conf(5)
- journal: "Unknown key name '...' in section 'Manager', ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemon_rules
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Unknown key name", "Unknown lvalue"])
def unknown_key(robot: Robot):
    yield from daemon_rules.unknown_keys(robot.system_conf, robot.target)
