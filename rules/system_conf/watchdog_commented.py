"""The watchdog settings are commented out: nothing is enabled.

## What it finds
A comment that sets RuntimeWatchdogSec, RebootWatchdogSec, ShutdownWatchdogSec or KExecWatchdogSec to a value
other than the default, while no file sets that key. The commented defaults in the distribution's file are
exempt.

## Why it matters on a robot
Someone wanted the hardware watchdog and believes that it is on. When the kernel hangs, nothing restarts the
robot.

## Bad
```ini
# [Manager]
#RuntimeWatchdogSec=20s
```

## Good
```ini
[Manager]
RuntimeWatchdogSec=20s
```

## When to ignore it
When the watchdog was disabled on purpose, for example because the board's driver resets the robot during a
long boot. Say so in the comment.

## References
- systemd-system.conf(5), "RuntimeWatchdogSec="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

DEFAULTS = {
    "RuntimeWatchdogSec": {"0", "off"},
    "RebootWatchdogSec": {"10min", "0"},
    "ShutdownWatchdogSec": {"10min", "0"},
    "KExecWatchdogSec": {"0", "off"},
}


@rule("warning", fix="unsafe", silent="a comment is not read")
def watchdog_commented(robot: Robot) -> Iterator[Finding]:
    for daemon in robot.system_conf:
        seen = set()
        for file, line, key, value in daemon.commented():
            if key not in DEFAULTS or value in DEFAULTS[key] or key in seen or not daemons.watchdog_seconds(value):
                continue
            if daemon.sets(key) or file.source.template:
                continue
            seen.add(key)
            header = "" if any(section.name == "Manager" for section in file.sections) else "[Manager]\n"
            first = header if len(seen) == 1 else ""
            yield finding(
                line,
                f"{key}={value} is commented out: nothing is enabled",
                advice="remove the #" + (" and add [Manager] above" if header else ""),
                fix=fix("remove the #", (line, f"{first}{key}={value}"), safe=False),
            )
