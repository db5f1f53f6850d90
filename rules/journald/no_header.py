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
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Assignment outside of section"])
def no_header(robot: Robot):
    for daemon in robot.journald:
        for first, count in daemons.headless(daemon):
            what = "this line is" if count == 1 else f"these {count} lines are"
            yield finding(
                first,
                f"Without [Journal] above, {what} ignored",
                advice="put [Journal] above",
                fix=fix("insert [Journal]", (first.part(0, 0), "[Journal]\n")),
            )
