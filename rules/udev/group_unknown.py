"""A rule names a group or user that nothing creates.

## What it finds
`GROUP` or `OWNER` with a name that Debian and Ubuntu systems do not have by default, and that no sysusers.d file,
script or document of the tree creates. In a root file system, /etc/group and /etc/passwd decide. In another tree that
creates no users or groups at all, it is an info: the accounts come from elsewhere. Silent where a task or command
creates accounts whose names it takes from variables.

## Why it matters on a robot
udev logs 'Unknown group, ignoring', and the device node stays with root: the driver gets 'permission denied'.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", GROUP="robots", MODE="0660"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", GROUP="dialout", MODE="0660"
```

## When to ignore it
If the group or user is created outside the linted tree, for example by the image build or the fleet
management, and as a local system account: udev resolves names before a directory service is up.

## References
- udev(7), OWNER and GROUP
- sysusers.d(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.udev import Token


@rule("warning", symptoms=["Unknown group", "Unknown user", "Failed to resolve group"])
def group_unknown(robot: Robot) -> Iterator[Finding]:
    unknown = list(_unknown(robot))
    if not unknown or (not robot.tree.complete and robot.accounts.creates_unnamed):
        return
    elsewhere = not robot.tree.complete and not robot.accounts.creates_any
    for token, what, instead in unknown:
        yield _finding(token, what, instead, elsewhere)


def _unknown(robot: Robot) -> Iterator[tuple[Token, str, str]]:
    """Groups and users that nothing creates, each with what it is and what to write instead."""
    for line in robot.udev.judged:
        for token in line.line.assignments("GROUP"):
            if _is_name(token) and not robot.accounts.has_group(token.value):
                yield token, "group", "dialout, or create the group with a sysusers.d file"
        for token in line.line.assignments("OWNER"):
            if _is_name(token) and not robot.accounts.has_user(token.value):
                yield token, "user", "root, or create the user with a sysusers.d file"


def _is_name(token: Token) -> bool:
    return bool(token.value) and not token.value.isdecimal() and not token.has_substitution


def _finding(token: Token, what: str, instead: str, elsewhere: bool) -> Finding:
    return finding(
        token.value,
        f"Nothing creates the {what} '{token.value}': udev ignores it, and the device node stays with root",
        advice=f"use {instead}",
        severity="info" if elsewhere else None,
    )
