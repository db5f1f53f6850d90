r"""The file name of a mount unit does not match Where=.

## What it finds
A .mount or .automount unit whose name is not the escaped form of Where=: slashes become dashes, and a dash in
the path becomes \x2d. Values with unknown specifiers are not checked.

## Why it matters on a robot
systemd refuses the unit. The disk for recordings or maps is not mounted, and programs write to the root disk
instead.

## Bad
```ini
# data.mount
[Mount]
What=/dev/disk/by-label/DATA
Where=/mnt/data
```

## Good
```ini
# mnt-data.mount
[Mount]
What=/dev/disk/by-label/DATA
Where=/mnt/data
```

## When to ignore it
Never: systemd refuses the unit.

## References
- systemd.mount(5), systemd-escape(1)
- journal: "Where= setting doesn't match unit name. Refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Where= setting doesn't match unit name"])
def mount_name_mismatch(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        is_named = not unit.is_template and not unit.instance and not robot.units.is_joined(unit)
        if unit.type not in ("mount", "automount") or not is_named:
            continue
        where = unit.get("Where")
        if where is None or "%" in where or "$" in where or not where.startswith("/") or unit.is_opaque(where):
            continue
        right = robot.units.mount_name(unit, where)
        if right not in (unit.name, *unit.aliases):
            yield finding(
                where,
                f"Where={where} does not match the name {unit.name}: systemd refuses the unit",
                advice=f"rename the file to {right}",
            )
