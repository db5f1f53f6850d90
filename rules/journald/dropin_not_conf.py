"""A drop-in that is not read: its name does not end in .conf.

## What it finds
A file in journald.conf.d, system.conf.d or logind.conf.d with the section of the daemon and another ending.

## Why it matters on a robot
systemd reads `*.conf` only. The settings have no effect, and nothing says so.

## Bad
```ini
/etc/systemd/journald.conf.d/10-robot.cfg
```

## Good
```ini
/etc/systemd/journald.conf.d/10-robot.conf
```

## References
- journald.conf(5)
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

BACKUPS = (
    ".bak",
    ".orig",
    ".old",
    ".disabled",
    ".off",
    "~",
    ".swp",
    ".dpkg-old",
    ".dpkg-dist",
    ".dpkg-new",
    ".rpmsave",
    ".rpmnew",
)


@rule("warning")
def dropin_not_conf(robot: Robot):
    for source in robot.of_kind("daemon-misnamed"):
        if source.judged and not source.basename.endswith(BACKUPS):
            yield finding(
                source,
                f"{source.basename} is not read: the name of a drop-in must end in .conf",
                advice="rename it",
            )
