r"""Blanks after a backslash break the line continuation.

## What it finds
A backslash at the end of a line with blanks after it.

## Why it matters on a robot
A backslash continues the line only if it is the very last character. With a blank after it, the command ends
there, and systemd ignores the next line or reads it as a setting of its own: the driver starts without its
arguments.

## Bad
```ini
[Service]
ExecStart=/usr/bin/robot-drivers \ 
    --port /dev/ttyUSB0
```

## Good
```ini
[Service]
ExecStart=/usr/bin/robot-drivers \
    --port /dev/ttyUSB0
```

## When to ignore it
Never: systemd does not continue the line.

## References
- systemd.syntax(7)
- journal: "Missing '=', ignoring line."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Missing '=', ignoring line"])
def backslash_space(robot: Robot) -> Iterator[Finding]:
    for _, problem in robot.units.problems("backslash-blank"):
        yield finding(
            problem.where,
            "Blanks after the backslash: systemd does not join the next line",
            advice="end the line with the backslash",
            fix=fix("remove the blanks", (problem.where, "\\")),
        )
