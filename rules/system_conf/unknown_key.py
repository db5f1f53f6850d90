"""A key that systemd does not know: the line is ignored.

## What it finds
A key in [Manager] of system.conf or a drop-in that no release knows, and one that the robot's release does
not know yet.

## Why it matters on a robot
The hardware watchdog stays off, or the default timeouts stay as they are; only one line in the journal tells.

## Bad
```ini
[Manager]
RuntimeWatchDogSec=20s
```

## Good
```ini
[Manager]
RuntimeWatchdogSec=20s
```

## References
- systemd-system.conf(5)
- journal: "Unknown key name '...' in section 'Manager', ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nearest
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Unknown key name", "Unknown lvalue"])
def unknown_key(robot: Robot):
    for daemon in robot.system_conf:
        for assignment in daemons.unknown_keys(daemon):
            key = assignment.key
            meant = nearest(key, daemons.setting_names(daemon.name))
            yield finding(
                key,
                f"Unknown key '{key}' in [Manager]: systemd ignores the line",
                advice=f"did you mean {meant[0]}?" if meant else "remove the line, or see systemd-system.conf(5)",
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
