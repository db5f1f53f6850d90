"""A key that systemd does not know: it ignores the line.

## What it finds
A key in [Manager] of system.conf or a drop-in that systemd ignores:

- error: no release of systemd knows the key;
- warning: the key is newer than the robot's release.

## Why it matters on a robot
The hardware watchdog stays off, or the default timeouts do not change. Only one line in the journal says so.

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

## When to ignore it
The warning, when the same file is deployed to robots with older and newer releases, and the older ones can do
without the setting. Never ignore the error: the key has no effect anywhere.

## References
- systemd-system.conf(5)
- journal: "Unknown key name '...' in section 'Manager', ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Unknown key name", "Unknown lvalue", "Unknown key '*' in section [Manager]"])
def unknown_key(robot: Robot) -> Iterator[Finding]:
    yield from daemons.unknown_keys(robot.system_conf, robot.target)
