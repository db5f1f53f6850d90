"""A drop-in that systemd does not read: its name does not end in .conf.

## What it finds
A file in journald.conf.d, system.conf.d or logind.conf.d that has the section of the daemon, but whose name
does not end in `.conf`. Backup copies such as `.bak` and `.dpkg-old` are exempt.

## Why it matters on a robot
systemd reads `*.conf` only. The settings have no effect, and no log line says so.

## Bad
```ini
/etc/systemd/journald.conf.d/10-robot.cfg
```

## Good
```ini
/etc/systemd/journald.conf.d/10-robot.conf
```

## When to ignore it
When the other ending is deliberate, as in a sample that is renamed during provisioning. Otherwise rename or
delete the file.

## References
- journald.conf(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
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


@rule("warning", silent="systemd does not read the file and does not report it")
def dropin_not_conf(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("daemon-misnamed"):
        if source.judged and not source.basename.endswith(BACKUPS):
            yield finding(
                source,
                f"{source.basename} is not read: the name of a drop-in must end in .conf",
                advice="rename it",
            )
