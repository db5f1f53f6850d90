"""A missing or extra brace: stanzas run into each other.

## What it finds
A stanza without `{`, a `}` that closes nothing, a stanza that is never closed, or a path where a directive
should be. A stanza that is not closed at the end of the file is a warning.

## Why it matters on a robot
logrotate skips the stanza, or the rest of the file. The logs grow until the disk is full.

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

## When to ignore it
Never: logrotate does not apply the file as written.

## References
- logrotate(8)
- logrotate: "unexpected log filename", "missing '{' after log files definition"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

WHAT = {
    "missing-open-brace": "No '{' after these paths: logrotate skips the rest of the file",
    "unexpected-brace": "This '}' closes nothing: logrotate skips the rest of the file",
    "unexpected-path": "The stanza above is not closed: logrotate skips it together with this one",
    "unclosed": "The stanza is never closed: anything appended to the file later becomes part of it",
}


@rule("error", symptoms=["unexpected log filename", "missing '{' after log files definition", "unexpected }"])
def missing_brace(robot: Robot) -> Iterator[Finding]:
    for file in robot.logs.files:
        for problem in file.problems:
            if problem.code in WHAT:
                yield finding(
                    problem.where,
                    WHAT[problem.code],
                    advice="write each stanza as PATHS { DIRECTIVES }, with the braces in place",
                    severity="warning" if problem.code == "unclosed" else None,
                )
