"""A service that has nothing to start: systemd refuses it.

## What it finds
A service without ExecStart=, after all drop-ins, where systemd requires one. Only a Type=oneshot service can
do without it, and only with ExecStop= and RemainAfterExit=yes, or with SuccessAction=.

## Why it matters on a robot
systemd refuses the unit: systemctl start fails with "bad unit file setting", and so does every unit that
requires it.

## Bad
```ini
[Service]
Type=oneshot
ExecStop=/usr/bin/robot-park
```

## Good
```ini
[Service]
Type=oneshot
RemainAfterExit=yes
ExecStop=/usr/bin/robot-park
```

## When to ignore it
When a drop-in outside of this tree adds ExecStart=.

## References
- systemd.service(5), "ExecStart="
- journal: "Service has no ExecStart=, ExecStop=, or SuccessAction=. Refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import directives


@rule(
    "error",
    symptoms=[
        "Service has no ExecStart=",
        "has a bad unit file setting",
        "Service lacks both ExecStart= and ExecStop= setting",
    ],
)
def exec_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        if unit.fragment is None or unit.uncertain or unit.has("ExecStart") or _misplaced(unit):
            continue
        reason = _refused(unit)
        if reason:
            yield finding(unit.where, f"{unit.name} {reason}: systemd refuses the unit", advice="add ExecStart=")


def _refused(unit: Unit) -> str:
    stops = unit.has("ExecStop")
    acts = unit.get("SuccessAction", "Unit") not in (None, "none")
    kind = unit.get("Type")
    if not stops and not acts:
        return "has no ExecStart="
    if kind not in (None, "oneshot"):
        return f"has Type={kind} and no ExecStart=, which only Type=oneshot allows"
    return "" if unit.flag("RemainAfterExit") or acts else "has only ExecStop= and not RemainAfterExit=yes"


def _misplaced(unit: Unit) -> bool:
    """Whether an Exec line is where systemd does not read it, which another rule reports."""
    known = directives.sections()
    for file in unit.files:
        if any(section.name not in known for section in file.sections) or file.problems:
            return True
        for assignment in file.assignments:
            key = assignment.key.lower()
            if key.startswith("exec") and directives.directive(assignment.section, assignment.key) is None:
                return True
    return False
