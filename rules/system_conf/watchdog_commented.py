"""The watchdog lines are comments: nothing is enabled.

## What it finds
RuntimeWatchdogSec and its likes with a value of their own, only in comments, while no file sets them. The
commented defaults of the distribution's file are left alone.

## Why it matters on a robot
Someone wanted the hardware watchdog and believes that it is on. A hung kernel leaves the robot standing
where it is.

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

## References
- systemd-system.conf(5), "RuntimeWatchdogSec="
"""

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


@rule("warning", fix="unsafe")
def watchdog_commented(robot: Robot):
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
                f"{key}={value} is only a comment: nothing is enabled",
                advice="remove the #" + (", and put [Manager] above" if header else ""),
                fix=fix("remove the #", (line, f"{first}{key}={value}"), safe=False),
            )
