"""Lines of journald.conf without [Journal] above them are ignored.

## What it finds
Settings in journald.conf or a drop-in before any section header.

## Why it matters on a robot
journald ignores lines outside its section; only a message in the journal tells. The limit that should keep
the disk from filling up, or the setting that should keep the logs of a crash, is simply not there.

## Bad
```ini
SystemMaxUse=1G
```

## Good
```ini
[Journal]
SystemMaxUse=1G
```

## References
- journald.conf(5)
- journal: "Assignment outside of section. Ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemon_rules
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Assignment outside of section"])
def no_header(robot: Robot):
    yield from daemon_rules.lines_without_section(robot.journald)
