"""A path unit that watches nothing: systemd refuses it.

## What it finds
A path unit without PathExists=, PathExistsGlob=, PathChanged=, PathModified= or DirectoryNotEmpty=, after all
drop-ins.

## Why it matters on a robot
systemd refuses the unit and never activates its service.

## Bad
```ini
[Path]
Unit=robot-upload.service
```

## Good
```ini
[Path]
PathChanged=/var/lib/robot/maps
Unit=robot-upload.service
```

## When to ignore it
When a drop-in outside of this tree adds the path.

## References
- systemd.path(5)
- journal: "Path unit lacks path setting. Refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_WATCHES = ("PathExists", "PathExistsGlob", "PathChanged", "PathModified", "DirectoryNotEmpty")


@rule("error", symptoms=["Path unit lacks path setting"])
def path_no_path(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        if unit.type != "path" or unit.fragment is None or unit.uncertain:
            continue
        if not any(unit.has(key) for key in _WATCHES):
            yield finding(
                unit.where,
                f"{unit.name} watches nothing: systemd refuses it",
                advice="add PathChanged= or another path setting",
            )
