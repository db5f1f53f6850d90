"""A required unit is masked.

## What it finds
`Requires=`, `Requisite=` or `BindsTo=` of a unit that a link to `/dev/null` or an empty file masks, or a script of the
tree whose mask nothing takes back.

## Why it matters on a robot
A masked unit cannot start, so that every unit that requires it fails: "Unit chrony.service is masked".
Somebody masks a unit by hand on one robot, and later its image becomes the image of all robots.

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

## When to ignore it
When the mask is meant to block both units, for example on a variant without this hardware.

## References
- systemctl(1), "mask"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import shell


@rule("error", symptoms=["is masked."])
def requires_masked(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    scripts = shell.masked_units(robot.scripts) if robot.of_kind("shell-script") else {}
    for unit in units.judged:
        for key in ("Requires", "Requisite", "BindsTo"):
            for word in unit.words(key):
                other = units.find(word, unit)
                masked: Located | Source | None = other.masked if other is not None else None
                if masked is None and word in scripts and robot.same_robot(word, scripts[word]):
                    masked = scripts[word]
                if masked:
                    yield finding(
                        word,
                        f"{word} is masked: {unit.name} fails to start",
                        advice=f"unmask it (systemctl unmask {word}), or remove the dependency",
                        related=[note(masked, "masked here")],
                    )
