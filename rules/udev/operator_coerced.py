"""udev reads an operator as a different one.

## What it finds
`MODE+=`, `GROUP+=`, `ATTR{...}:=`, `ENV{...}:=`, `TAG:=` and similar combinations, which udev reads as `=`
with a warning.

## Why it matters on a robot
With `:=` the value was meant to be final, but a later file can still change it. `TAG:=` removes the tags set
before, including `systemd` and `uaccess`.

## Bad
```udev
KERNEL=="ttyACM*", MODE+="0660"
```

## Good
```udev
KERNEL=="ttyACM*", MODE="0660"
```

## When to ignore it
If `=` is what you want and the file must stay identical to that of a vendor: only the warning in the journal
remains.

## References
- udev(7), "Operators"
- `udevadm verify`: takes ... operator, assuming '='
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="safe", symptoms=["operator, assuming '='"])
def operator_coerced(robot: Robot) -> Iterator[Finding]:
    for problem, _ in robot.udev.problems("coerced-operator"):
        yield finding(
            problem.where,
            f"udev reads {problem.detail}{problem.where} as {problem.detail}=",
            advice="write = if this is intended",
            fix=fix("write what udev does", (problem.where, "=")),
        )
