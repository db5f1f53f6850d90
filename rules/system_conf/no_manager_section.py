"""Settings outside of a section in system.conf: systemd ignores them.

## What it finds
Settings in system.conf or a drop-in before any section header.

## Why it matters on a robot
systemd ignores lines outside of a section. The hardware watchdog stays off, or the default timeouts do not
change. Only one line in the journal says so.

## Bad
```ini
RuntimeWatchdogSec=20s
```

## Good
```ini
[Manager]
RuntimeWatchdogSec=20s
```

## When to ignore it
Only if the file is a fragment that another tool appends to a file with a [Manager] header. systemd itself
always ignores these lines.

## References
- systemd-system.conf(5)
- journal: "Assignment outside of section. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Assignment outside of section"])
def no_manager_section(robot: Robot) -> Iterator[Finding]:
    yield from daemons.lines_without_section(robot.system_conf)
