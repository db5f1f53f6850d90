"""A service runs as a user or group that does not exist.

## What it finds
`User=` or `Group=` with a name that /etc/passwd or /etc/group of the root file system does not have, and that
no sysusers.d file of the tree makes.

## Why it matters on a robot
systemd cannot start the process: the service fails with 217/USER or 216/GROUP at every boot.

## Bad
```ini
[Service]
User=rovr
ExecStart=/opt/rover/bin/base
```

## Good
```ini
[Service]
User=rover
ExecStart=/opt/rover/bin/base
```

## When to ignore it
When the user comes from a directory service such as LDAP, which systemd asks too.

## References
- systemd.exec(5), User= and Group=; "Process Exit Codes"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "status=217/USER",
        "status=216/GROUP",
        "Failed to determine user credentials",
        "Failed at step USER spawning",
        "Failed at step GROUP spawning",
        "Failed to determine group credentials",
        "Failed to determine supplementary groups",
    ],
)
def user_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        identity = unit.identity
        if unit.manager != "system" or identity.dynamic or identity.dynamic.unknown or unit.is_template:
            continue
        user, name = identity.user, identity.name
        if user and name and not name.isdecimal() and robot.accounts.has_user(name) is False:
            yield finding(
                user,
                f"The user {name} does not exist: {unit.name} fails with 217/USER",
                advice="create the user, or correct the name",
            )
        group = identity.group
        if group and not unit.is_opaque(group) and group.isidentifier() and robot.accounts.has_group(group) is False:
            yield finding(
                group,
                f"The group {group} does not exist: {unit.name} fails with 216/GROUP",
                advice="create the group, or correct the name",
            )
