"""A job in a system crontab has no user.

## What it finds
A job in `/etc/cron.d` or `/etc/crontab` whose user field is a path or a command instead of a user.

## Why it matters on a robot
cron takes the first word of the command as the user: `Error: bad username`. No job of the file runs.

## Bad
```
0 3 * * * /opt/robot/clean
```

## Good
```
0 3 * * * root /opt/robot/clean
```

## When to ignore it
When a user on the robot really has the name of this command.

## References
- crontab(5)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

FIELD = r"[\w*/,@~-]+"
JOB = regex(rf"^[ \t]*(?:@\w+|{FIELD}(?:[ \t]+{FIELD}){{4}})[ \t]+(\S+)", re.M)
COMMANDS = frozenset(
    (
        "bash",
        "sh",
        "python3",
        "ros2",
        "cd",
        "source",
        ".",
        "test",
        "[",
        "sudo",
        "systemctl",
        "docker",
        "find",
        "rm",
    )
)


@rule("error", symptoms=["bad username; while reading"])
def no_user_field(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("cron"):
        for match in JOB.finditer(source.text):
            word = source.located(match.start(1), match.end(1))
            if "/" in word or word in COMMANDS:
                yield finding(
                    word,
                    f"cron takes '{word}' as the user: no job of this file runs",
                    advice="add the user before the command, for example root",
                )
