"""A unit that is ordered after, or wants, one that does not exist.

## What it finds
`Wants=`, `Upholds=`, `After=`, `Before=` or `PartOf=` of a unit that neither the tree nor the distribution
has. In a root file system that is a warning for names that look like the robot's own, and information for
others, which may be optional; in a repository only the former are reported, unless a script makes the unit.

## Why it matters on a robot
systemd says nothing about it: the line has no effect. What was meant to wait for the drivers does not wait,
because they are called `rover-drivers.service` and not `rover-driver.service`.

## Bad
```ini
[Unit]
After=rover-driver.service
```

## Good
```ini
[Unit]
After=rover-drivers.service
```

## References
- systemd.unit(5), "Wants=", "After="
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

KEYS = ("Wants", "Upholds", "After", "Before", "PartOf")


@rule("warning", fix="unsafe")
def missing_wanted_unit(robot: Robot):
    units = robot.units
    for unit in units.judged:
        required = {word for key in ("Requires", "Requisite", "BindsTo") for word in unit.words(key)}
        seen = set()
        for key in KEYS:
            for line in unit.assignments(key):
                for word in line.value.words() if not line.opaque else ():
                    if word in required or word in seen or not units.is_missing(word, unit):
                        continue
                    seen.add(word)
                    meant = units.meant(word, unit)
                    yield finding(
                        word,
                        f"{key}={word} has no effect: there is no such unit"
                        + ("" if robot.tree.complete else " in this tree"),
                        advice=f"did you mean {meant}?" if meant else "correct the name, or drop the line",
                        fix=fix(f"write {meant}", (word, meant), safe=False) if meant else None,
                        severity=None if units.is_own(word, unit) else "info",
                        confidence="high" if robot.tree.complete else "medium",
                    )
