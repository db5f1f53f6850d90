"""%h in a system service is the home of root, not of its user.

## What it finds
`%h`, `%u` and `%U` in a system service with a `User=` other than root, except in commands that run as root (`+`, `!`).

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
from bringup_lint.api.systemd import Assignment

SPECIFIER = regex(r"(?<!%)(?:%%)*(?P<written>%(?P<letter>[huU]))", hints="%")
PLAIN = regex(r"[a-z][a-z\d_-]*")
BY_ROOT = regex(r"[@:|-]*[+!]")
SINGLE = ("WorkingDirectory", "RootDirectory", "StandardOutput", "StandardError", "PIDFile")
MEANS = {"h": "/root", "u": "root", "U": "0"}


@rule("error", symptoms=["status=200/CHDIR", "Changing to the requested working directory failed"])
def specifier_of_manager(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("%h", "%u", "%U"):
        return
    for unit in robot.units.services:
        user = unit.identity.user
        if unit.manager != "system" or user is None or not PLAIN.fullmatch(user) or unit.identity.is_root is not False:
            continue
        assignments = [each for file in unit.files for each in file.assignments]
        for at, assignment in enumerate(assignments):
            found = SPECIFIER.search(assignment.value)
            if found is not None and not _is_other(assignment) and not _is_replaced(assignment, assignments[at + 1 :]):
                letter = found["letter"]
                yield finding(
                    assignment.value.part(*found.span("written")),
                    f"%{letter} is {MEANS[letter]} in a system unit, whatever User= says",
                    advice="write what it is for the user of the service",
                    related=[note(user, "the user of the service")],
                )


def _is_other(assignment: Assignment) -> bool:
    """Whether no program of the user gets the value."""
    key = assignment.key
    unread = key in ("Description", "Documentation") or key.startswith("X-") or assignment.section.startswith("X-")
    return unread or BY_ROOT.match(assignment.value) is not None


def _is_replaced(assignment: Assignment, later: list[Assignment]) -> bool:
    """Whether a later line takes the place of this one."""
    same = (each for each in later if each.key == assignment.key)
    return any(assignment.key in SINGLE or not each.value for each in same)
