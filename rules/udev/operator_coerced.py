"""udev reads an operator as another one.

## What it finds
`MODE+=`, `GROUP+=`, `ATTR{...}:=`, `ENV{...}:=`, `TAG:=` and the like, which udev takes for `=` with a
warning.

## Why it matters on a robot
`:=` was meant to make the value final, and a later file still changes it; `TAG:=` drops the tags set before,
`systemd` and `uaccess` among them.

## Bad
```udev
KERNEL=="ttyACM*", MODE+="0660"
```

## Good
```udev
KERNEL=="ttyACM*", MODE="0660"
```

## References
- udev(7), "Operators"
- `udevadm verify`: takes ... operator, assuming '='
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="safe", symptoms=["operator, assuming '='"])
def operator_coerced(robot: Robot):
    for problem, _ in robot.udev.problems("coerced-operator"):
        yield finding(
            problem.where,
            f"udev takes {problem.detail}{problem.where} for {problem.detail}=",
            advice="write = if that is meant",
            fix=fix("write what udev does", (problem.where, "=")),
        )
