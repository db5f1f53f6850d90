"""A working directory that does not exist, or is in another user's home.

## What it finds
`WorkingDirectory=` below `/home`, in a complete root file system, that does not exist or is in the home of a
user other than `User=`.

## Why it matters on a robot
The service does not start: `status=200/CHDIR`. The path was right on the developer's machine, where the user
had another name.

## Bad
```ini
[Service]
User=rover
WorkingDirectory=/home/dev/ros2_ws
```

## Good
```ini
[Service]
User=rover
WorkingDirectory=~
```

## When to ignore it
When the directory is created at the first boot, or is shared with the service's user on purpose.

## References
- systemd.exec(5), "WorkingDirectory="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

HOME = regex(r"(/home/[^/]+)(?:/|$)")


@rule(
    "info",
    symptoms=[
        "status=200/CHDIR",
        "Changing to the requested working directory failed",
        "Failed at step CHDIR spawning",
    ],
)
def workdir_missing_user_home(robot: Robot) -> Iterator[Finding]:
    if not robot.tree.complete:
        return
    for unit in robot.units.services:
        path = unit.get("WorkingDirectory")
        home = HOME.match(path) if path and "%" not in path else None
        user = unit.identity.user
        if path is None or home is None or unit.has("RootDirectory") or unit.is_opaque(path):
            continue
        own = robot.accounts.home_of(str(unit.identity.name)) if user else None
        if robot.tree.has(str(path)) is False and robot.tree.entries("/home"):
            message = f"{path} does not exist: {unit.name} fails with 200/CHDIR"
        elif own and own != home[1]:
            message = f"{path} is not in {own}, the home of {user}"
        else:
            continue
        yield finding(
            path,
            message,
            advice="write WorkingDirectory=~, or a path that the service's user owns",
            related=[note(user, "the user of the service")] if user else (),
        )
