"""A unit is installed into a target that does not exist.

## What it finds
`WantedBy=`, `RequiredBy=` or `UpheldBy=` with one of these:

- error: a word that is not a unit name;
- error, in a complete root file system: a unit that neither the tree nor the distribution has;
- warning, in a repository: an unknown target, which another package may ship, or another unknown unit whose
  name looks like the robot's own.

## Why it matters on a robot
`systemctl enable` creates the link and reports success ("added as a dependency to a non-existent unit" at
most). But nothing ever starts the target, so that nothing starts the service. The robot boots without it.

## Bad
```ini
[Install]
WantedBy=rover-bringup.target
```

## Good
```ini
[Install]
WantedBy=multi-user.target
```

## When to ignore it
When another package ships the target.

## References
- systemd.unit(5), "WantedBy="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule(
    "error",
    fix="unsafe",
    symptoms=["added as a dependency to a non-existent unit", "is not a valid unit name"],
)
def install_bad_target(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.judged:
        for key in ("WantedBy", "RequiredBy", "UpheldBy"):
            for line in unit.assignments(key, "Install"):
                if line.opaque:
                    continue
                for word in line.value.words():
                    bad = "%" not in word and not units.is_name(word)
                    if not bad and not units.is_install_target_missing(word, unit):
                        continue
                    known = units.install_targets(unit)
                    same = [name for name in known if name.rpartition(".")[0] == word]
                    meant = same or nearest(word, known)
                    sure = bad or robot.tree.complete
                    yield finding(
                        word,
                        f"{word} is not a unit name: systemctl enable fails"
                        if bad
                        else (
                            f"{word} does not exist{'' if sure else ' in this tree'}: "
                            f"{unit.name} can be enabled but never starts"
                        ),
                        advice=f"did you mean {meant[0]}?" if meant else f"ship {word}, or use multi-user.target",
                        fix=fix(f"write {meant[0]}", (word, meant[0]), safe=False) if len(meant) == 1 else None,
                        severity=None if sure else "warning",
                        confidence="high" if sure else "medium",
                    )
