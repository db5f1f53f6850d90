"""A user or group that does not exist: logrotate skips the whole stanza.

## What it finds
A user or group of `create`, `createolddir` or `su` that does not exist in a complete root file system:
neither in its databases nor in sysusers.d.

## Why it matters on a robot
logrotate skips the stanza, and the logs grow until the disk is full.

## Bad
```
/var/log/ros2/*.log {
    su robt robot
}
```

## Good
```
/var/log/ros2/*.log {
    su robot robot
}
```

## When to ignore it
When the account is created at the first boot, or comes from a directory service such as LDAP.

## References
- logrotate(8), "su", "create"
- logrotate: "unknown user 'robt'"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["unknown user", "unknown group"])
def unknown_user(robot: Robot) -> Iterator[Finding]:
    for file in robot.logs.files:
        for directive in [*file.directives, *(each for stanza in file.stanzas for each in stanza.directives)]:
            user, group = robot.logs.owners(directive)
            accounts = robot.accounts
            for name, kind, known in (
                (user, "user", accounts.has_user),
                (group, "group", accounts.has_group),
            ):
                if name is not None and not name.isdecimal() and known(name) is False:
                    yield finding(
                        name,
                        f"There is no {kind} '{name}': logrotate skips the whole stanza",
                        advice=f"create the {kind}, or name one that exists",
                    )
