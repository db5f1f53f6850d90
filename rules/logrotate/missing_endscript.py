"""A script without endscript: logrotate drops the stanza.

## What it finds
A prerotate, postrotate, firstaction, lastaction or preremove that no line `endscript` ends.

## Why it matters on a robot
logrotate takes the rest of the file as the script, then drops the stanza: its logs are never rotated.

## Bad
```
/var/log/ros2/*.log {
    postrotate
        systemctl try-restart robot.service
}
```

## Good
```
/var/log/ros2/*.log {
    postrotate
        systemctl try-restart robot.service
    endscript
}
```

## When to ignore it
Never: logrotate drops the stanza.

## References
- logrotate(8)
- logrotate: "prerotate, postrotate or preremove without endscript"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["without endscript"])
def missing_endscript(robot: Robot) -> Iterator[Finding]:
    for file in robot.logs.files:
        for problem in file.problems:
            if problem.code == "missing-endscript":
                yield finding(
                    problem.where,
                    f"{problem.where} has no endscript: logrotate drops the stanza and everything after it",
                    advice="end the script with a line endscript",
                )
