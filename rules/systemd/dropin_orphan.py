"""Drop-ins of a unit that does not exist, or never runs.

## What it finds
A folder such as `rover-driver.service.d`, while neither the tree nor the distribution has
`rover-driver.service`. In a repository, the tree must also have a unit with nearly the same name. Folders for
groups of units (`service.d`, `rover-.service.d`) and generated units are exempt. Also drop-ins of a unit that a script
of the tree masks, and that nothing unmasks.

## Why it matters on a robot
The settings in the drop-in (a memory limit, a user, a restart) apply to nothing, and no tool says so.

## Bad
```
rover-driver.service.d/limits.conf
rover-drivers.service
```

## Good
```
rover-drivers.service.d/limits.conf
rover-drivers.service
```

## When to ignore it
When the unit comes from a package that is installed later, or is created at run time.

## References
- systemd.unit(5), "Description": drop-in files
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import shell


@rule("warning", silent="systemd reads drop-ins only for units that it loads")
def dropin_orphan(robot: Robot) -> Iterator[Finding]:
    yield from _of_masked(robot)
    units = robot.units
    for file in units.orphans:
        near = next((unit for unit in units.all if file in unit.dropins), None)
        if near is None or units.is_made_by_script(file.name):
            continue
        meant = units.meant(file.name, near)
        if not meant and not robot.tree.complete:
            continue
        yield finding(
            file.sections[0].header if file.sections else file.source,
            f"There is no {file.name}, so this drop-in applies to nothing",
            advice=f"did you mean {meant}.d?" if meant else "rename the folder after its unit, or delete it",
            related=[
                note(other.where, "a unit with a similar name")
                for other in units.candidates(meant or "")
                if other.files
            ],
        )


def _of_masked(robot: Robot) -> Iterator[Finding]:
    dropins = [file for file in robot.units.unit_files if file.dropin and file.sections]
    masked = shell.masked_units(robot.scripts) if dropins and robot.of_kind("shell-script") else {}
    for file in dropins:
        word = masked.get(file.name)
        if word is not None and robot.same_robot(file.source, word):
            yield finding(
                file.sections[0].header,
                f"{file.name} is masked, so this drop-in applies to nothing",
                advice="give it to the unit that runs in its place, or delete it",
                related=[note(word, "masked here")],
            )
