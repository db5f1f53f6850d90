"""MODE is written without its leading zero.

## What it finds
A `MODE` of three octal digits, such as `MODE="660"`.

## Why it matters on a robot
udev reads the value as octal in any case, but a reader may not expect that.

## Bad
```udev
KERNEL=="ttyACM*", MODE="660"
```

## Good
```udev
KERNEL=="ttyACM*", MODE="0660"
```

## When to ignore it
If your rules consistently use three digits: the mode is the same.

## References
- udev(7), MODE
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("info", fix="safe", silent="udev reads the number as octal in both forms")
def mode_no_leading_zero(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for token in line.line.assignments("MODE"):
            if re.fullmatch(r"[1-7][0-7]{2}", token.value):
                yield finding(
                    token.value,
                    f"{token.value} is read as octal; a leading zero makes that visible",
                    advice=f"write 0{token.value}",
                    fix=fix("add the zero", (token.value, f"0{token.value}")),
                )
