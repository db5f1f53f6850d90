"""A section that journald does not read.

## What it finds
A section other than [Journal] in journald.conf or a drop-in. Sections that start with X- are meant for
other programs and are fine.

## Why it matters on a robot
journald ignores the section with everything in it. The limit that should keep the disk from filling up, or
the setting that should keep the logs of a crash, is simply not there.

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

## References
- journald.conf(5)
- journal: "Unknown section '...'. Ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemon_rules
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Unknown section"])
def unknown_section(robot: Robot):
    yield from daemon_rules.unknown_sections(robot.journald)
