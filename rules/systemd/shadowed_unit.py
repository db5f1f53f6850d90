"""A unit in /etc hides the packaged one completely.

## What it finds
A unit file in a directory of higher priority (`/etc/systemd/system`) of the same name as one in a lower one
(`/usr/lib/systemd/system`). Masks and links are left out.

## Why it matters on a robot
The two are never merged: what the package changes later, a security fix among it, does not arrive. A
drop-in keeps the packaged file and changes only what it names.

## Bad
```
/etc/systemd/system/chrony.service
/usr/lib/systemd/system/chrony.service
```

## Good
```
/etc/systemd/system/chrony.service.d/wait.conf
/usr/lib/systemd/system/chrony.service
```

## References
- systemd.unit(5), "Unit File Load Path"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info")
def shadowed_unit(robot: Robot) -> Iterator[Finding]:
    for hidden, unit in robot.units.shadowed:
        if unit.fragment is None or unit.fragment.source.link or not hidden.source.robot_path:
            continue
        own = unit.fragment.source
        if not own.robot_path or own.robot_path.rpartition("/")[0] == hidden.source.robot_path.rpartition("/")[0]:
            continue
        yield finding(
            own,
            f"{own.robot_path} hides {hidden.source.robot_path} completely: nothing of it applies",
            advice=f"put what differs into {unit.name}.d/*.conf",
            related=[note(hidden.source, "hidden")],
        )
