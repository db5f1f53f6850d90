"""A service depends on a workspace in another user's home.

## What it finds
A service with `User=` that sources a setup file, or starts a program, below the `/home` folder of another
user.

## Why it matters on a robot
Home folders are closed to others (mode 0750 on Ubuntu). The service cannot read the workspace, or only until
somebody fixes the permissions. It also ties the robot to one developer's account.

## Bad
```ini
[Service]
User=rover
ExecStart=/bin/bash -c 'source /home/dev/ws/install/setup.bash && exec ros2 launch rover rover.launch.py'
```

## Good
```ini
[Service]
User=rover
ExecStart=/bin/bash -c 'source /opt/rover/install/setup.bash && exec ros2 launch rover rover.launch.py'
```

## When to ignore it
On a development robot where the other user's home is readable on purpose.

## References
- adduser.conf(5), "DIR_MODE"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

HOME = re.compile(r"/home/([^/$%]+)/")


@rule("info")
def hardcoded_ws_home(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.services:
        user = unit.get("User")
        if user in (None, "root", "0") or "%" in user or unit.is_opaque(user):
            continue
        for process in units.started(unit):
            words = [process.program, *(word for _, word in process.setup_files)]
            found = next((word for word in words if (home := HOME.match(word)) and home[1] != user), None)
            if found and robot.accounts.home_of(str(user)) != f"/home/{HOME.match(found)[1]}":
                yield finding(
                    found,
                    f"{unit.name} runs as {user} but needs files in the home of {HOME.match(found)[1]}",
                    advice=f"install it below /opt, or in the home of {user}",
                    related=[note(user, "the user of the service")],
                )
                break
