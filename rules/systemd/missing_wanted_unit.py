"""A unit wants, or is ordered after, a unit that does not exist.

## What it finds
`Wants=`, `Upholds=`, `After=`, `Before=` or `PartOf=` of a unit that neither the tree nor the distribution
has.

- It is a warning for names that look like the robot's own, unless a script of the repository creates the
  unit, and for targets that nobody has, such as `docker.target`, where the distribution has a service of that name.
- It is a warning, too, for names that the system manager does not have in any distribution, such as those of the sound
  servers, which only the managers of users have. `udisks.service`, which is called udisks2, is an info where it only
  gives an order: D-Bus starts that one for whoever asks it.
- It is an info for names of which four or more that begin with the same word are missing: another package
  brings them.
- It is an info for other names, which may be optional, and only in a complete root file system.

## Why it matters on a robot
systemd does not report it: the line has no effect. The service that should wait for the drivers does not
wait, because they are called `rover-drivers.service` and not `rover-driver.service`.

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

## When to ignore it
When the unit is optional and comes from a package that some robots do not have.

## References
- systemd.unit(5), "Wants=", "After="
"""

from collections import Counter
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Units

KEYS = ("Wants", "Upholds", "After", "Before", "PartOf")
OF_A_PACKAGE = 4
"""So many missing units with the same first word are no misspellings: another package brings them."""
GONE = {
    "udisks.service": "udisks2.service",
    "network-online.service": "network-online.target",
    "time-sync.service": "time-sync.target",
    "pulseaudio.service": "",
    "pipewire.service": "",
    "wireplumber.service": "",
}
"""Names that the system manager does not have, each with the one that is meant; empty: units of the user manager."""
STARTED_WHEN_ASKED = {"udisks.service"}
"""Those of a program that D-Bus starts."""


def renamed(unit: Unit, name: str, meant: str) -> Iterator[tuple[Located, str]]:
    """Edits that write another name in all dependencies of a unit."""
    for key in KEYS:
        for line in unit.assignments(key):
            if not line.opaque:
                yield from ((word, meant) for word in line.value.words() if word == name)


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "Cannot add dependency job, ignoring: Unit * not found.",
        "Cannot add dependency job for unit *, ignoring: Unit * not found.",
    ],
)
def missing_wanted_unit(robot: Robot) -> Iterator[Finding]:
    found = list(missing(robot))
    known = {(word.partition("-")[0], str(word)) for _, _, word in found if "-" in word}
    shared = Counter(package for package, _ in known)
    for unit, key, word in found:
        meant = GONE.get(word) or robot.units.meant(word, unit) or robot.units.service_of_target(word, unit)
        elsewhere = not meant and shared[word.partition("-")[0]] >= OF_A_PACKAGE
        yield finding(
            word,
            f"{key}={word} has no effect: there is no such unit" + ("" if robot.tree.complete else " in this tree"),
            advice=f"did you mean {meant}?" if meant else "correct the name, or remove the line",
            fix=fix(f"write {meant}", *renamed(unit, word, meant), safe=False) if meant else None,
            severity=None if _is_sure(robot.units, word, unit, key) and not elsewhere else "info",
            confidence="high" if robot.tree.complete else "medium",
        )


def _is_sure(units: Units, name: str, unit: Unit, key: str) -> bool:
    if name in GONE:
        return name not in STARTED_WHEN_ASKED or key not in ("After", "Before")
    return units.is_own(name, unit) or units.service_of_target(name, unit) is not None


def _is_gone(units: Units, name: str, unit: Unit) -> bool:
    """Whether a name is one that no distribution has, and the tree neither."""
    if name not in GONE or unit.manager != "system" or units.is_made_by_script(name):
        return False
    return not list(units.candidates(name, "system"))


def missing(robot: Robot) -> Iterator[tuple[Unit, str, Located]]:
    """The units, each once for the unit that names it, that do not exist: who names it, and under which key."""
    for unit in robot.units.judged:
        required = {word for key in ("Requires", "Requisite", "BindsTo") for word in unit.words(key)}
        seen = set()
        for key in KEYS:
            words = (word for line in unit.assignments(key) if not line.opaque for word in line.value.words())
            for word in words:
                if word in required or word in seen:
                    continue
                is_gone = robot.units.is_missing(word, unit) or _is_gone(robot.units, word, unit)
                if is_gone or robot.units.service_of_target(word, unit) is not None:
                    seen.add(word)
                    yield unit, key, word
