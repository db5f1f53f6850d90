"""A mount unit without What=: systemd refuses it.

## What it finds
A .mount unit without What=, after all drop-ins.

## Why it matters on a robot
systemd refuses the unit. The disk is not mounted, and programs write to the root disk instead.

## Bad
```ini
[Mount]
Where=/mnt/data
```

## Good
```ini
[Mount]
What=/dev/disk/by-label/DATA
Where=/mnt/data
```

## When to ignore it
When a drop-in outside of this tree adds What=.

## References
- systemd.mount(5), "What="
- journal: "What= setting is missing. Refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["What= setting is missing"])
def mount_no_what(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        if unit.type == "mount" and unit.fragment and not unit.uncertain and not unit.has("What"):
            yield finding(unit.where, f"{unit.name} has no What=: systemd refuses it", advice="add What=")
