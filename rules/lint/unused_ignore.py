"""A suppression comment has no effect.

## What it finds
A name in `bringup-lint: ignore[...]` or `ignore-file[...]` that suppressed no finding, although its rules ran. The same
for an entry of `[per-file-ignores]` in the configuration, for a pattern there that matches no file, and for an
`[[accept]]` of a fleet.

## Why it matters on a robot
Either the defect is fixed, or the comment is on the wrong line or misspells the rule. Then the accepted finding is
reported again, or the comment would silently suppress a new one.

## Bad
```ini
[Service]
# bringup-lint: ignore[systemd/root-usr]: the driver needs raw sockets
ExecStart=/usr/bin/robot-driver
```

## Good
```ini
[Service]
# bringup-lint: ignore[systemd/root-user]: the driver needs raw sockets
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch base driver.launch.py'
```

## When to ignore it
When the finding depends on the environment, for example on a file that only some checkouts have.

## References
- the README, "Suppressing findings"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule


@rule("warning", silent="it is about a comment that only bringup-lint reads")
def unused_ignore(robot: Robot) -> Iterator[Finding]:
    """Reported by the engine when all other rules have run."""
    return iter(())
