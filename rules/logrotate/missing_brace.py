"""A brace too few or too many: stanzas run into each other.

## What it finds
A stanza without `{`, a `}` that closes nothing, a stanza that is never closed, a path where a directive
should be.

## Why it matters on a robot
logrotate skips the stanza, or reads nothing of the file from there on; the logs grow until the disk is full.

## Bad
```
/var/log/ros2/*.log {
    weekly
/var/log/nav/*.log {
    weekly
}
```

## Good
```
/var/log/ros2/*.log {
    weekly
}
/var/log/nav/*.log {
    weekly
}
```

## References
- logrotate(8)
- logrotate: "unexpected log filename", "missing '{' after log files definition"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

WHAT = {
    "missing-open-brace": "No '{' after these paths: logrotate reads nothing of the file from here on",
    "unexpected-brace": "This '}' closes nothing: logrotate reads nothing of the file from here on",
    "unexpected-path": "The stanza above is not closed: logrotate skips it together with this one",
    "unclosed": "The stanza is never closed: logrotate takes what is there, and all that is appended later",
}


@rule("error", symptoms=["unexpected log filename", "missing '{' after log files definition", "unexpected }"])
def missing_brace(robot: Robot):
    for file in robot.logs.files:
        for problem in file.problems:
            if problem.code in WHAT:
                yield finding(
                    problem.where,
                    WHAT[problem.code],
                    advice="write each stanza as PATHS { DIRECTIVES }, with the braces in place",
                    severity="warning" if problem.code == "unclosed" else None,
                )
