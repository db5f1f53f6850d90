"""A value that logind cannot parse: it ignores the line.

## What it finds
A value in [Login] of logind.conf or a drop-in that does not follow the grammar of its key.

## Why it matters on a robot
Shared memory is still deleted at logout, or closing the lid still suspends the robot.

## Bad
```ini
[Login]
HandleLidSwitch=ignored
```

## Good
```ini
[Login]
HandleLidSwitch=ignore
```

## When to ignore it
Never: logind ignores the line, so that it has no effect. Correct or delete it.

## References
- logind.conf(5), systemd.syntax(7), systemd.time(7)
- journal: "Failed to parse ... value, ignoring"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Failed to parse", "ignoring:"])
def invalid_value(robot: Robot) -> Iterator[Finding]:
    yield from daemons.invalid_values(robot.logind, robot.target)
