r"""A trailing backslash that joins nothing.

## What it finds
A backslash at the end of the last line of a file, or of a line before a blank line.

## Why it matters on a robot
The value ends there. As soon as somebody adds a line after it, that line becomes part of the value above.

## Bad
```ini
[Service]
ExecStart=/usr/bin/robot-drivers \

User=robot
```

## Good
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
User=robot
```

## When to ignore it
Never: the backslash has no use, and removing it changes nothing.

## References
- systemd.syntax(7): a trailing backslash joins the next line
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="safe", silent="systemd takes the last line as it is")
def continuation_at_eof(robot: Robot) -> Iterator[Finding]:
    for _, problem in robot.units.problems("continuation-at-end"):
        yield finding(
            problem.where,
            "The trailing backslash joins nothing: the value ends here",
            advice="remove the backslash",
            fix=fix("remove the backslash", (problem.where, "")),
        )
