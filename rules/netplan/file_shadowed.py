"""A netplan file is hidden by one of the same name.

## What it finds
The same file name in two of netplan's folders. `/run/netplan` hides `/etc/netplan`, which hides
`/lib/netplan`.

## Why it matters on a robot
The hidden file is not merged but left out whole; who edits it wonders why nothing changes.

## Bad
```
/run/netplan/10-robot.yaml
/etc/netplan/10-robot.yaml
```

## Good
```
/run/netplan/20-test.yaml
/etc/netplan/10-robot.yaml
```

## References
- netplan-generate(8), "Handling multiple files"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info")
def file_shadowed(robot: Robot) -> Iterator[Finding]:
    for hidden, winner in robot.netplan.shadowed:
        yield finding(
            hidden.source,
            f"{winner.source.name} hides this file completely",
            advice="give one of them another name",
            related=[note(winner.source, "this file is read")],
        )
