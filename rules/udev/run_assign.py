"""RUN= removes the programs of other rules.

## What it finds
`RUN=` with a plain equals sign.

## Why it matters on a robot
The list of programs that earlier rules added for the device is cleared, including those of the distribution.

## Bad
```udev
KERNEL=="ttyACM*", RUN="/usr/local/bin/announce"
```

## Good
```udev
KERNEL=="ttyACM*", RUN+="/usr/local/bin/announce"
```

## When to ignore it
If the rule is meant to replace the programs of earlier rules, for example to disable a vendor's hook.

## References
- udev(7), RUN
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("info", fix="unsafe", silent="udev drops the other programs without a message")
def run_assign(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for token in line.line.assignments("RUN"):
            if token.operator == "=":
                yield finding(
                    token.operator,
                    "RUN= removes the programs that earlier rules added for the device",
                    advice="write +=",
                    fix=fix("add the program", (token.operator, "+=")),
                )
