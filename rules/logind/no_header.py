"""Lines of logind.conf without [Login] above them are ignored.

## What it finds
Settings in logind.conf or a drop-in before any section header.

## Why it matters on a robot
logind ignores lines outside its section; only a message in the journal tells. Shared memory is still
deleted at logout, or closing the lid still suspends the robot.

## Bad
```ini
RemoveIPC=no
```

## Good
```ini
[Login]
RemoveIPC=no
```

## References
- logind.conf(5)
- journal: "Assignment outside of section. Ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Assignment outside of section"])
def no_header(robot: Robot):
    for daemon in robot.logind:
        for first, count in daemons.headless(daemon):
            what = "this line is" if count == 1 else f"these {count} lines are"
            yield finding(
                first,
                f"Without [Login] above, {what} ignored",
                advice="put [Login] above",
                fix=fix("insert [Login]", (first.part(0, 0), "[Login]\n")),
            )
