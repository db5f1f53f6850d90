"""A required unit is masked.

## What it finds
`Requires=`, `Requisite=` or `BindsTo=` of a unit that a link to `/dev/null` or an empty file masks.

## Why it matters on a robot
A masked unit cannot start, so the start of what requires it fails: "Unit chrony.service is masked". Masks
are set by hand on one robot, and forgotten when its image becomes the image of all.

## Bad
```ini
# /etc/systemd/system/base.service -> /dev/null
[Unit]
Requires=base.service
```

## Good
```ini
[Unit]
Wants=base.service
```

## References
- systemctl(1), "mask"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["is masked."])
def requires_masked(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.judged:
        for key in ("Requires", "Requisite", "BindsTo"):
            for word in unit.words(key):
                other = units.find(word, unit)
                if other is not None and other.masked:
                    yield finding(
                        word,
                        f"{word} is masked: {unit.name} fails to start",
                        advice=f"unmask it (systemctl unmask {word}), or drop the dependency",
                        related=[note(other.masked, "masked here")],
                    )
