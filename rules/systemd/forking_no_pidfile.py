"""A forking service without a PID file: systemd guesses its main process.

## What it finds
A service with Type=forking and neither PIDFile= nor GuessMainPID=.

## Why it matters on a robot
The guess is unreliable as soon as the daemon has more than one process. systemd may then watch, restart and
signal the wrong one.

## Bad
```ini
[Service]
Type=forking
ExecStart=/usr/sbin/gpsd /dev/ttyUSB0
```

## Good
```ini
[Service]
Type=forking
PIDFile=/run/gpsd.pid
ExecStart=/usr/sbin/gpsd -P /run/gpsd.pid /dev/ttyUSB0
```

## When to ignore it
When the daemon always leaves exactly one process.

## References
- systemd.service(5), "PIDFile=", "GuessMainPID="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", symptoms=["Supervising process * which is not our child. We'll most likely not notice when it exits."])
def forking_no_pidfile(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        kind = unit.get("Type")
        if kind != "forking" or unit.fragment is None or unit.uncertain:
            continue
        if not unit.has("PIDFile") and unit.flag("GuessMainPID").at is None:
            message = f"systemd has to guess the main process of {unit.name}"
            yield finding(kind, message, advice="add PIDFile=, or run the program in the foreground with Type=exec")
