"""systemd never kills a process that hangs.

## What it finds
FinalKillSignal= with a signal other than SIGKILL, or SendSIGKILL=no, on a service that starts ROS 2.
FinalKillSignal= does not add a third step: it replaces the SIGKILL at the end.

## Why it matters on a robot
A driver that hangs ignores both SIGINT and SIGTERM. It keeps the device open, and the stop job waits in vain.
So does the shutdown.

## Bad
```ini
[Service]
KillSignal=SIGINT
FinalKillSignal=SIGTERM
```

## Good
```ini
[Service]
KillSignal=SIGINT
TimeoutStopSec=20
```

## When to ignore it
When killing the process would be more dangerous than leaving it, for example while it writes firmware.

## References
- systemd.kill(5), FinalKillSignal= and SendSIGKILL=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import delete_lines


@rule("error", fix="unsafe", symptoms=["Processes still around after final SIGTERM. Entering failed mode."])
def final_kill_signal(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        if service.final_signal.value not in ("SIGKILL", None) and service.sends_kill.value:
            text = (
                f"FinalKillSignal= replaces SIGKILL with {service.final_signal.value}: a hung process "
                f"of {unit.name} is never killed"
            )
            yield finding(
                service.final_signal.where,
                text,
                advice="delete the line",
                fix=_without(unit, "FinalKillSignal", service.final_signal.at),
            )
        if service.sends_kill.value is False:
            yield finding(
                service.sends_kill.where,
                f"SendSIGKILL=no: a hung process of {unit.name} is never killed",
                advice="delete the line",
                fix=_without(unit, "SendSIGKILL", service.sends_kill.at),
            )


def _without(unit: Unit, key: str, value: Located | None) -> Fix | None:
    lines = [line for line in unit.assignments(key, "Service") if line.value is value]
    return fix("let systemd send SIGKILL at the end", *map(delete_lines, lines)) if unit.editable else None
