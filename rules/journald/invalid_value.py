"""A value that journald cannot parse: it ignores the line.

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

## When to ignore it
Never: journald ignores the line, so that it has no effect. Correct or delete it.

## References
- journald.conf(5), systemd.syntax(7), systemd.time(7)
- journal: "Failed to parse ... value, ignoring"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Failed to parse", "ignoring:"])
def invalid_value(robot: Robot) -> Iterator[Finding]:
    yield from daemons.invalid_values(robot.journald, robot.target)
