"""A required unit does not exist.

## What it finds
`Requires=`, `Requisite=` or `BindsTo=` of a unit that neither the tree nor the distribution has.

- In a complete root file system it is an error.
- In a repository it is a warning, and only for names that look like the robot's own: the same first word as a
  unit of the tree, or nearly the same name. Units that a script of the repository creates are exempt.

Devices, mounts, slices and generated units are exempt.

## Why it matters on a robot
The start fails at once: "Unit rover-hw.target not found". Every unit that requires this unit fails with it.

## Bad
```ini
[Unit]
Requires=rover-hw.target
After=rover-hw.target
```

## Good
```ini
# the same package ships rover-hw.target
[Unit]
Requires=rover-hw.target
After=rover-hw.target
```

## When to ignore it
When another package ships the unit, or a generator creates it at boot.

## References
- systemd.unit(5), "Requires="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

KEYS = ("Requires", "Requisite", "BindsTo")


@rule(
    "error",
    fix="unsafe",
    symptoms=["Failed to start *: Unit * not found.", "not found.", "Failed to start: Unit not found"],
)
def missing_required_unit(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.judged:
        for key in KEYS:
            for line in unit.assignments(key):
                if line.opaque:
                    continue
                for word in line.value.words():
                    if not units.is_missing(word, unit):
                        continue
                    meant = units.meant(word, unit)
                    yield finding(
                        word,
                        f"{word} does not "
                        f"exist{'' if robot.tree.complete else ' in this tree'}: {unit.name} fails to start",
                        advice=f"did you mean {meant}?" if meant else f"ship {word}, or remove the dependency",
                        fix=fix(f"write {meant}", (word, meant), safe=False) if meant else None,
                        severity=None if robot.tree.complete else "warning",
                        confidence="high" if robot.tree.complete else "medium",
                    )
