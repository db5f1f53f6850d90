"""A unit in /etc hides the packaged one completely.

## What it finds
A unit file in a directory of higher priority (`/etc/systemd/system`) with the same name as one in a directory
of lower priority (`/usr/lib/systemd/system`). Masks and links are exempt.

## Why it matters on a robot
systemd never merges the two: later changes in the package, such as a security fix, have no effect. A drop-in
keeps the packaged file and changes only the settings that it names.

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

## When to ignore it
When the unit in /etc is a complete replacement on purpose.

## References
- systemd.unit(5), "Unit File Load Path"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", symptoms=["[OVERRIDDEN] /etc/systemd/system/* → /*/systemd/system/*"])
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
            advice=f"move the differences to {unit.name}.d/*.conf",
            related=[note(hidden.source, "the hidden file")],
        )
