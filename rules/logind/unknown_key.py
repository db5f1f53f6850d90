"""A key that logind does not know: the line is ignored.

## What it finds
A key in [Login] of logind.conf or a drop-in that no release knows, and one that the robot's release does
not know yet.

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

## References
- logind.conf(5)
- journal: "Unknown key name '...' in section 'Login', ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemon_rules
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Unknown key name", "Unknown lvalue"])
def unknown_key(robot: Robot):
    yield from daemon_rules.unknown_keys(robot.logind, robot.target)
