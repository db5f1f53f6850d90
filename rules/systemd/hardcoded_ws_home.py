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

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit

HOME = regex(r"/home/([^/$%]+)/", hints="/home/")


@rule("info", symptoms=["/home/*/install/setup.bash: No such file or directory"])
def hardcoded_ws_home(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("/home/"):
        user = unit.identity.user
        found = next(_in_other_homes(robot, unit), None) if unit.identity.is_other else None
        if user is None or found is None:
            continue
        word, owner = found
        yield finding(
            word,
            f"{unit.name} runs as {user} but needs files in the home of {owner}",
            advice=f"install it below /opt, or in the home of {user}",
            related=[note(user, "the user of the service")],
        )


def _in_other_homes(robot: Robot, unit: Unit) -> Iterator[tuple[Located, str]]:
    """The programs and setup files in the home of another user, with that user."""
    name = unit.identity.name
    if name is None:
        return
    own = robot.accounts.home_of(name)
    for process in robot.units.started(unit):
        for word in (process.program, *(word for _, word in process.setup_files)):
            home = HOME.match(word)
            if home and home[1] != name and own != f"/home/{home[1]}":
                yield word, home[1]
