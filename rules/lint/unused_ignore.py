"""A suppression comment hits nothing.

## What it finds
A name in `bringup-lint: ignore[...]` or `ignore-file[...]` for which no finding was silenced, although its rules ran.

## Why it matters on a robot
The defect is gone, or the comment stands on the wrong line or misspells the rule: then the finding that somebody
decided about is reported again, or a new one would be silenced unseen.

## Bad
```ini
[Service]
# bringup-lint: ignore[systemd/root-usr] -- the driver needs raw sockets
ExecStart=/usr/bin/robot-driver
```

## Good
```ini
[Service]
# bringup-lint: ignore[systemd/root-user] -- the driver needs raw sockets
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch base driver.launch.py'
```

## References
- the README, "Suppressing findings"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule


@rule("warning")
def unused_ignore(robot: Robot) -> Iterator[Finding]:
    """Reported by the engine when all other rules have run."""
    return ()
