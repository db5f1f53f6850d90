"""A section that logind does not read.

## What it finds
A section other than [Login] in logind.conf or a drop-in. Sections that start with X- are meant for other
programs and are fine.

## Why it matters on a robot
logind ignores the section with everything in it. Shared memory is still deleted at logout, or closing the
lid still suspends the robot.

## Bad
```ini
[Service]
RemoveIPC=no
```

## Good
```ini
[Login]
RemoveIPC=no
```

## References
- logind.conf(5)
- journal: "Unknown section '...'. Ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemon_rules
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Unknown section"])
def unknown_section(robot: Robot):
    yield from daemon_rules.unknown_sections(robot.logind)
