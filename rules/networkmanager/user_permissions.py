"""A profile comes up only while a user is logged in.

## What it finds
`permissions=user:NAME` in a profile that connects by itself.

## Why it matters on a robot
NetworkManager activates the profile only while that user has a session. A robot boots without one: it has no network
until somebody logs in at its console. Graphical tools write the line when "all users may connect" is off.

## Bad
```ini
[connection]
id=depot
permissions=user:robot:;
```

## Good
```ini
[connection]
id=depot
permissions=
```

## When to ignore it
If the profile is for a laptop or a service session only.

## References
- nm-settings(5), "permissions"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="unsafe", silent="NetworkManager waits for the user without a message")
def user_permissions(robot: Robot) -> Iterator[Finding]:
    for profile in robot.networkmanager.judged:
        permissions = profile.get("connection", "permissions")
        if permissions is None or not permissions.startswith("user:") or not profile.comes_up:
            continue
        user = permissions[5:].split(":")[0].rstrip(";")
        yield finding(
            permissions,
            f"{profile.name} comes up only while {user} is logged in: after a boot there is no network",
            advice="leave permissions empty",
            fix=fix("leave permissions empty", (permissions, ""), safe=False),
        )
