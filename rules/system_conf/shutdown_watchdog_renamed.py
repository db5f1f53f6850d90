"""systemd 243 renamed ShutdownWatchdogSec= to RebootWatchdogSec=.

## What it finds
`ShutdownWatchdogSec=` in [Manager].

## Why it matters on a robot
The old name still works as a second spelling of the same setting. If both are set, the later one wins.

## Bad
```ini
[Manager]
ShutdownWatchdogSec=2min
```

## Good
```ini
[Manager]
RebootWatchdogSec=2min
```

## When to ignore it
When the file must also work with systemd older than 243, which knows only the old name.

## References
- systemd-system.conf(5), "RebootWatchdogSec="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", fix="safe", silent="systemd reads the old name as an alias without a message")
def shutdown_watchdog_renamed(robot: Robot) -> Iterator[Finding]:
    for daemon in robot.system_conf:
        new = next((line.assignment for line in daemon.lines if line.assignment.key == "RebootWatchdogSec"), None)
        for line in daemon.lines:
            key = line.assignment.key
            if key == "ShutdownWatchdogSec" and line.file.source.judged:
                yield finding(
                    key,
                    "ShutdownWatchdogSec= is the old name of RebootWatchdogSec="
                    + (", which is also set" if new else ""),
                    advice="delete one of the two" if new else "write RebootWatchdogSec=",
                    related=[note(new.key, "the same setting")] if new else (),
                    fix=None if new or line.file.source.template else fix("rename", (key, "RebootWatchdogSec")),
                    severity="warning" if new else None,
                )
