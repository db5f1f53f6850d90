"""A rule starts a unit that does not exist.

## What it finds
`ENV{SYSTEMD_WANTS}` with a unit that neither the root file system nor the distribution has. In a repository,
only a name that nearly equals that of a unit in the tree is reported.

## Why it matters on a robot
The device appears, but systemd only logs that it did not find the unit: the driver never starts.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A1", TAG+="systemd", ENV{SYSTEMD_WANTS}+="base-drive.service"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A1", TAG+="systemd", ENV{SYSTEMD_WANTS}+="base_driver.service"
```

## When to ignore it
If another package installs the unit on the robot, and the similar name in this tree is a coincidence.

## References
- systemd.device(5), SYSTEMD_WANTS=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit


@rule("error", symptoms=["Unit not found", "Failed to enqueue SYSTEMD_WANTS= job"])
def systemd_wants_unit_missing(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for token in line.line.assignments("ENV"):
            if token.attribute != "SYSTEMD_WANTS":
                continue
            for name in token.value.words():
                near = _nearest(robot, name)
                if _is_missing(robot, name) and (robot.tree.complete or near):
                    yield finding(
                        name,
                        f"Unit {name} does not exist: the device starts nothing",
                        advice=f"did you mean {near.name}?" if near else "install the unit, or name one that exists",
                        related=[note(near.where, f"{near.name} is here")] if near else [],
                    )


def _is_missing(robot: Robot, name: str) -> bool:
    stem, at, rest = name.partition("@")
    plain = f"{stem}@.{rest.rpartition('.')[2]}" if at else str(name)
    if "%" in plain or "$" in plain or "." not in plain:
        return False
    return not robot.units.candidates(plain) and robot.units.is_provided(plain) is False


def _nearest(robot: Robot, name: str) -> Unit | None:
    from difflib import get_close_matches

    units = {unit.name: unit for unit in robot.units.all if unit.judged and unit.type == name.rpartition(".")[2]}
    near = get_close_matches(name, units, 1, 0.85)
    return units[near[0]] if near else None
