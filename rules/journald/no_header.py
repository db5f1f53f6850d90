"""Settings outside of a section in journald.conf: journald ignores them.

## What it finds
Settings in journald.conf or a drop-in before any section header.

## Why it matters on a robot
journald ignores lines outside of a section and says so only in the journal. The limit that should keep the
disk from filling up, or the setting that should preserve the logs of a crash, has no effect.

## Bad
```ini
SystemMaxUse=1G
```

## Good
```ini
[Journal]
SystemMaxUse=1G
```

## When to ignore it
Only if the file is a fragment that another tool appends to a file with a [Journal] header. journald itself
always ignores these lines.

## References
- journald.conf(5)
- journal: "Assignment outside of section. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Assignment outside of section"])
def no_header(robot: Robot) -> Iterator[Finding]:
    yield from daemons.lines_without_section(robot.journald)
