"""A section that systemd does not read.

## What it finds
A section other than [Manager] in system.conf or a drop-in. Sections that start with X- are meant for other
programs and are fine.

## Why it matters on a robot
systemd ignores the section with everything in it. The hardware watchdog stays off, or the default timeouts
stay as they are; only one line in the journal tells.

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

## References
- systemd-system.conf(5)
- journal: "Unknown section '...'. Ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemon_rules
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Unknown section"])
def unknown_section(robot: Robot):
    yield from daemon_rules.unknown_sections(robot.system_conf)
