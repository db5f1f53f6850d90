"""A user unit that starts only when somebody logs in.

## What it finds
An enabled unit of a user manager in a root file system, when lingering is off (no file in
`/var/lib/systemd/linger`): for that user, if the unit is in a home, and otherwise for all users.

## Why it matters on a robot
The user manager starts at the first login and stops after the last logout. On the bench, somebody is always
logged in. In the field nobody is, and the service does not run, or stops when the SSH connection drops.

## Bad
```
/home/rover/.config/systemd/user/default.target.wants/nav.service
```

## Good
```
/home/rover/.config/systemd/user/default.target.wants/nav.service
/var/lib/systemd/linger/rover
```

## When to ignore it
When the unit is only for people who log in, for example a desktop tool, or when provisioning runs `loginctl
enable-linger`.

## References
- loginctl(1), "enable-linger"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

HOME = regex(r"/home/([^/]+)/")
LINGER = "/var/lib/systemd/linger"


@rule(
    "warning",
    symptoms=[
        "Failed to connect to bus: $DBUS_SESSION_BUS_ADDRESS and $XDG_RUNTIME_DIR not defined",
        "Failed to connect to bus: No medium found",
    ],
)
def user_unit_no_linger(robot: Robot) -> Iterator[Finding]:
    lingering = robot.tree.entries(LINGER)
    if lingering is None:
        return
    for link in robot.units.links:
        own = [unit for unit in robot.units.candidates(link.name, "user") if unit.judged and unit.fragment]
        path = link.source.robot_path
        if link.manager != "user" or not path or path.startswith(("/usr/", "/lib/")) or not own:
            continue
        home = HOME.match(path)
        if home[1] in lingering if home else lingering:
            continue
        yield finding(
            link.source,
            f"{link.name} starts only when {home[1] if home else 'somebody'} logs in, and stops after the last logout",
            advice=f"run loginctl enable-linger {home[1] if home else 'USER'}, or use a system unit with User=",
            related=[note(own[0].where, "the unit")],
        )
