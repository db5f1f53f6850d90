"""A value that journald cannot read: the line is ignored.

## What it finds
A value in [Journal] of journald.conf or a drop-in that does not follow the grammar of its key.

## Why it matters on a robot
The default applies: the journal may take 10 % of the disk, or is kept in memory only.

## Bad
```ini
[Journal]
SystemMaxUse=1GB
```

## Good
```ini
[Journal]
SystemMaxUse=1G
```

## References
- journald.conf(5), systemd.syntax(7), systemd.time(7)
- journal: "Failed to parse ... value, ignoring"
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemon_rules
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Failed to parse", "ignoring:"])
def invalid_value(robot: Robot):
    yield from daemon_rules.invalid_values(robot.journald, robot.target)
