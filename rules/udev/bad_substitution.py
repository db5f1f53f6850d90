"""A value contains a substitution that udev does not know.

## What it finds
`$name` or `%letter` in an assigned value that udev(7) does not list, or `$attr` or `$env` without braces. A
literal `$` or `%` is written `$$` or `%%`. In commands (`RUN`, `PROGRAM`, `IMPORT`) the finding is only
information.

## Why it matters on a robot
udev logs an error and keeps the text unchanged (`%s` without braces becomes empty), so the link gets a name
that the driver does not open. In a command the text reaches the program unchanged, so a shell may still
expand it, but each event logs the error.

## Bad
```udev
SUBSYSTEM=="tty", SYMLINK+="robot/imu-$serial"
```

## Good
```udev
SUBSYSTEM=="tty", SYMLINK+="robot/imu-$attr{serial}"
```

## When to ignore it
In a command for a shell that expands the variable itself, such as `$HOME`, if you accept a log message at
every event.

## References
- udev(7), "Substitutions"
- `udevadm verify`: invalid substitution type
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_COMMANDS = ("RUN", "PROGRAM", "IMPORT")


@rule("error", symptoms=["invalid substitution type", "attribute value missing"])
def bad_substitution(robot: Robot) -> Iterator[Finding]:
    for problem, line in robot.udev.problems("bad-substitution", "substitution-without-argument"):
        token = next(token for token in line.tokens if token.span.start <= problem.span.start < token.span.end)
        what = "has no {...}" if problem.code == "substitution-without-argument" else "is unknown to udev"
        yield finding(
            problem.where,
            f"The substitution '{problem.where}' {what}: {token.key} gets another value than intended",
            advice=f"write a substitution of udev(7), or {problem.word[0] * 2} for a literal {problem.word[0]}",
            severity="info" if token.key in _COMMANDS else None,
        )
