"""A section that systemd does not read.

## What it finds
A section other than [Manager] in system.conf or a drop-in. Sections whose name starts with `X-` are for other
programs and are exempt.

## Why it matters on a robot
systemd ignores the whole section. The hardware watchdog stays off, or the default timeouts do not change.
Only one line in the journal says so.

## Bad
```ini
[System]
RuntimeWatchdogSec=20s
```

## Good
```ini
[Manager]
RuntimeWatchdogSec=20s
```

## When to ignore it
Never: systemd ignores the section. Rename it, or prefix it with `X-` if another program reads it.

## References
- systemd-system.conf(5)
- journal: "Unknown section '...'. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Unknown section"])
def unknown_section(robot: Robot) -> Iterator[Finding]:
    yield from daemons.unknown_sections(robot.system_conf)
