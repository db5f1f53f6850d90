"""A key that logind does not know: it ignores the line.

## What it finds
A key in [Login] of logind.conf or a drop-in that logind ignores:

- error: no release of systemd knows the key;
- warning: the key is newer than the robot's release.

## Why it matters on a robot
Shared memory is still deleted at logout, or closing the lid still suspends the robot.

## Bad
```ini
[Login]
RemoveIpc=no
```

## Good
```ini
[Login]
RemoveIPC=no
```

## When to ignore it
The warning, when the same file is deployed to robots with older and newer releases, and the older ones can do
without the setting. Never ignore the error: the key has no effect anywhere.

## References
- logind.conf(5)
- journal: "Unknown key name '...' in section 'Login', ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Unknown key name", "Unknown lvalue", "Unknown key '*' in section [Login]"])
def unknown_key(robot: Robot) -> Iterator[Finding]:
    yield from daemons.unknown_keys(robot.logind, robot.target)
