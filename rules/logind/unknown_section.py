"""A section that logind does not read.

## What it finds
A section other than [Login] in logind.conf or a drop-in. Sections whose name starts with `X-` are for other
programs and are exempt.

## Why it matters on a robot
logind ignores the whole section. Shared memory is still deleted at logout, or closing the lid still suspends
the robot.

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

## When to ignore it
Never: logind ignores the section. Rename it, or prefix it with `X-` if another program reads it.

## References
- logind.conf(5)
- journal: "Unknown section '...'. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Unknown section"])
def unknown_section(robot: Robot) -> Iterator[Finding]:
    yield from daemons.unknown_sections(robot.logind)
