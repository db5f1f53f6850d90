"""A user unit that waits for a login.

## What it finds
In a root file system: an enabled unit of a user manager, while nobody (for a unit in a home: not that user)
has lingering switched on (`/var/lib/systemd/linger/USER`).

## Why it matters on a robot
The user manager starts at the first login and stops after the last logout. On the desk somebody is always
logged in; in the field nobody is, and the service does not run, or stops when the SSH connection drops.

## Bad
```
/home/rover/.config/systemd/user/default.target.wants/nav.service
```

## Good
```
/home/rover/.config/systemd/user/default.target.wants/nav.service
/var/lib/systemd/linger/rover
```

## References
- loginctl(1), "enable-linger"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

HOME = re.compile(r"/home/([^/]+)/")
LINGER = "/var/lib/systemd/linger"


@rule("warning")
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
            advice=f"loginctl enable-linger {home[1] if home else 'USER'}, or a system unit with User=",
            related=[note(own[0].where, "the unit")],
        )
