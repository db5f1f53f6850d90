r"""Blanks behind a backslash stop the line from being continued.

## What it finds
A backslash with blanks behind it at the end of a line.

## Why it matters on a robot
Only a backslash that is the very last character joins the next line. With a blank behind it the command
ends there, and the next line is dropped or read as a setting of its own: the driver starts without its
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

## References
- systemd.syntax(7)
- journal: "Missing '=', ignoring line."
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Missing '=', ignoring line"])
def backslash_space(robot: Robot):
    for file in robot.units.files:
        for problem in file.problems:
            if problem.code == "backslash-blank":
                yield finding(
                    problem.where,
                    "Blanks behind the backslash: systemd does not join the next line",
                    advice="end the line with the backslash",
                    fix=fix("remove the blanks", (problem.where, "\\")),
                )
