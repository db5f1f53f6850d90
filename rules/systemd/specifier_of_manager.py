"""%h in a system service is the home of root, not of its user.

## What it finds
`%h`, `%u` and `%U` in a system service with a `User=` other than root.

## Why it matters on a robot
These specifiers are about the user of the service manager, and `User=` does not change them: `%h` is /root, `%u` is
root and `%U` is 0. A working directory there does not exist or may not be entered (200/CHDIR), and a program below it
is not found.

## Bad
```ini
[Service]
User=rover
WorkingDirectory=%h/rover_ws
```

## Good
```ini
[Service]
User=rover
WorkingDirectory=/home/rover/rover_ws
```

## When to ignore it
When root's own home is meant, and the user may read it.

## References
- systemd.unit(5), "Specifiers"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

SPECIFIER = regex(r"(?<!%)(?:%%)*(?P<written>%(?P<letter>[huU]))")
MEANS = {"h": "/root", "u": "root", "U": "0"}


@rule("error", symptoms=["status=200/CHDIR", "Changing to the requested working directory failed"])
def specifier_of_manager(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        user = unit.identity.user
        if unit.manager != "system" or user is None or "%" in user or unit.identity.is_root is not False:
            continue
        for assignment in (each for file in unit.files for each in file.assignments):
            found = SPECIFIER.search(assignment.value)
            if found is not None and assignment.key not in ("Description", "Documentation"):
                letter = found["letter"]
                yield finding(
                    assignment.value.part(*found.span("written")),
                    f"%{letter} is {MEANS[letter]} in a system unit, whatever User= says",
                    advice="write what it is for the user of the service",
                    related=[note(user, "the user of the service")],
                )
