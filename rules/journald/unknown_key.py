"""A key that journald does not know: the line is ignored.

## What it finds
A key in [Journal] of journald.conf or a drop-in that no release knows, and one that the robot's release
does not know yet.

## Why it matters on a robot
The limit that should keep the disk from filling up, or the setting that should keep the logs of a crash,
is simply not there.

## Bad
```ini
[Journal]
SystemMaxSize=1G
```

## Good
```ini
[Journal]
SystemMaxUse=1G
```

## References
- journald.conf(5)
- journal: "Unknown key name '...' in section 'Journal', ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nearest
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Unknown key name", "Unknown lvalue"])
def unknown_key(robot: Robot):
    for daemon in robot.journald:
        for assignment in daemons.unknown_keys(daemon):
            key = assignment.key
            meant = nearest(key, daemons.setting_names(daemon.name))
            yield finding(
                key,
                f"Unknown key '{key}' in [Journal]: journald ignores the line",
                advice=f"did you mean {meant[0]}?" if meant else "remove the line, or see journald.conf(5)",
                fix=fix(f"rename to {meant[0]}", (key, meant[0])) if len(meant) == 1 else None,
            )
        target = robot.target
        for assignment, since in daemons.newer_keys(daemon, target.systemd) if target.systemd_known else ():
            yield finding(
                assignment.key,
                f"{assignment.key}= needs systemd {since}; the robot has {target.systemd} ({target.systemd_why}), "
                "which ignores it",
                advice=f"remove the line, or update to systemd {since}",
                severity="warning",
            )
