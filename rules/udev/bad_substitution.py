"""A value holds a substitution that udev does not know.

## What it finds
`$name` or `%letter` in an assigned value that udev(7) does not list, `$attr` or `$env` without braces. A `$`
or `%` that is meant itself is written `$$` or `%%`.

## Why it matters on a robot
udev complains in the journal and keeps the text as it stands (`%s` without braces becomes empty), so the link
gets another name than the driver opens. In commands for a shell the text reaches the shell unchanged; there
it is a matter of clean logs.

## Bad
```udev
SUBSYSTEM=="tty", SYMLINK+="robot/imu-$serial"
```

## Good
```udev
SUBSYSTEM=="tty", SYMLINK+="robot/imu-$attr{serial}"
```

## References
- udev(7), "Substitutions"
- `udevadm verify`: invalid substitution type
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_COMMANDS = ("RUN", "PROGRAM", "IMPORT")


@rule("error", symptoms=["invalid substitution type", "attribute value missing"])
def bad_substitution(robot: Robot):
    for problem, line in robot.udev.problems("bad-substitution"):
        token = next(token for token in line.tokens if token.span.start <= problem.where.span.start < token.span.end)
        what = "lacks its {...}" if problem.detail == "argument missing" else "is unknown to udev"
        yield finding(
            problem.where,
            f"The substitution '{problem.where}' {what}: {token.key} does not get what was meant",
            advice=f"write a substitution of udev(7), or {problem.where[0] * 2} for the character itself",
            severity="info" if token.key in _COMMANDS else None,
        )
