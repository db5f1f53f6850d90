"""A section that journald does not read.

## What it finds
A section other than [Journal] in journald.conf or a drop-in. Sections whose name starts with `X-` are for
other programs and are exempt.

## Why it matters on a robot
journald ignores the whole section. The limit that should keep the disk from filling up, or the setting that
should preserve the logs of a crash, has no effect.

## Bad
```ini
[Service]
SystemMaxUse=1G
```

## Good
```ini
[Journal]
SystemMaxUse=1G
```

## When to ignore it
Never: journald ignores the section. Rename it, or prefix it with `X-` if another program reads it.

## References
- journald.conf(5)
- journal: "Unknown section '...'. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Unknown section"])
def unknown_section(robot: Robot) -> Iterator[Finding]:
    yield from daemons.unknown_sections(robot.journald)
