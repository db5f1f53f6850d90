"""User= or Group= in a user unit: the service does not start.

## What it finds
`User=`, `Group=` or `SupplementaryGroups=` in a service of the user manager.

## Why it matters on a robot
The user manager may not change the user or the groups of its processes. The service fails with `216/GROUP` or
`217/USER` before its program runs.

## Bad
```ini
# ~/.config/systemd/user/rviz.service
[Service]
User=rover
```

## Good
```ini
# ~/.config/systemd/user/rviz.service
[Service]
ExecStart=/opt/rover/bin/rviz
```

## When to ignore it
Never: the user manager always runs the unit as its own user.

## References
- systemd.exec(5), "User="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.systemd import delete_lines


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "Failed to determine supplementary groups: Operation not permitted",
        "status=216/GROUP",
        "status=217/USER",
    ],
)
def user_unit_user_key(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        if unit.manager != "user":
            continue
        for key in ("User", "Group", "SupplementaryGroups"):
            lines = [line for line in unit.assignments(key) if line.value and line.span.source.judged]
            if lines and unit.values(key):
                yield finding(
                    lines[-1].value,
                    f"{key}= does not work in a user unit: {unit.name} fails to start",
                    advice="delete the line, or make it a system unit",
                    fix=fix("delete the line", delete_lines(lines[-1])),
                )
