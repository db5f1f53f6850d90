"""Settings outside of a section in logind.conf: logind ignores them.

## What it finds
Settings in logind.conf or a drop-in before any section header.

## Why it matters on a robot
logind ignores lines outside of a section and says so only in the journal. Shared memory is still deleted at
logout, or closing the lid still suspends the robot.

## Bad
```ini
RemoveIPC=no
```

## Good
```ini
[Login]
RemoveIPC=no
```

## When to ignore it
Only if the file is a fragment that another tool appends to a file with a [Login] header. logind itself always
ignores these lines.

## References
- logind.conf(5)
- journal: "Assignment outside of section. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Assignment outside of section"])
def no_header(robot: Robot) -> Iterator[Finding]:
    yield from daemons.lines_without_section(robot.logind)
