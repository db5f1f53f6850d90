"""A value that logrotate cannot parse: it skips the whole stanza.

## What it finds
A count, size, mode, owner or path that logrotate rejects, or a directive that lacks its value. Size suffixes
are k, M and G, without B.

## Why it matters on a robot
One bad value makes logrotate skip the whole stanza or, above the first stanza, the rest of the file. The logs
of that stanza grow until the disk is full.

## Bad
```
/var/log/ros2/*.log {
    size 100MB
    copytruncate
}
```

## Good
```
/var/log/ros2/*.log {
    size 100M
    copytruncate
}
```

## When to ignore it
Never: logrotate skips the stanza, whatever else it says.

## References
- logrotate(8), "size"
- logrotate: "found error in /var/log/ros2/*.log, skipping"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.logrotate import LogrotateFile
from bringup_lint.api.schema import wrong_value

WHAT = {
    "argument-expected": "{name} needs a value",
    "bad-number": "{name} takes a whole number, not '{value}'",
    "bad-size": "'{value}' is not a size (logrotate knows k, M and G)",
    "unknown-unit": "'{value}' is not a size (logrotate knows k, M and G)",
    "bad-weekday": "weekly takes a day from 0 to 7, not '{value}'",
    "extra-arguments": "{name} has too many arguments ('{value}')",
    "su-incomplete": "su needs a user and a group",
    "bad-address": "mail takes one address, not '{value}'",
    "bad-path": "{name} takes one path without blanks, not '{value}'",
    "bad-options": "{name} cannot be split into words: '{value}'",
    "global-only": "{name} is not allowed inside a stanza",
}
SIZE = regex(r"(\d+)\s*([kKmMgG])(?:i?[bB])?")


@rule(
    "error",
    fix="unsafe",
    symptoms=["found error in", "unknown unit", "bad size", "bad rotation count", "argument expected after"],
)
def bad_value(robot: Robot) -> Iterator[Finding]:
    for file in robot.logs.files:
        for problem in file.problems:
            if problem.code not in WHAT:
                continue
            value = problem.word
            text = meant(value) if problem.code in ("bad-size", "unknown-unit") else None
            what = WHAT[problem.code].format(name=problem.detail or value, value=value)
            yield wrong_value(value, f"{what}: {cost(file, value)}", text, "see logrotate(8) for the accepted values")


def meant(value: Located) -> str | None:
    found = SIZE.fullmatch(value)
    return f"{found[1]}{found[2].lower() if found[2] in 'kK' else found[2].upper()}" if found else None


def cost(file: LogrotateFile, value: Located) -> str:
    if file.unread_from is not None and file.unread_from >= value.span.start:
        after = [problem for problem in file.problems if problem.span.start > value.span.start]
        if not after:
            return "logrotate reads nothing of the file from here on"
    return "logrotate skips the whole stanza"
