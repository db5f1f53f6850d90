"""A key that journald does not know: the line is ignored.

## What it finds
A key in [Journal] of journald.conf or a drop-in that no release knows, and one that the robot's release
does not know yet.

## Why it matters on a robot
The limit that should keep the disk from filling up, or the setting that should keep the logs of a crash,
is simply not there.

## Bad
```ini
[Journal]
SystemMaxSize=1G
```

## Good
```ini
[Journal]
SystemMaxUse=1G
```

## References
- journald.conf(5)
- journal: "Unknown key name '...' in section 'Journal', ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemon_rules
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Unknown key name", "Unknown lvalue"])
def unknown_key(robot: Robot):
    yield from daemon_rules.unknown_keys(robot.journald, robot.target)
