"""A timer requires the service that it is to start later.

## What it finds
A timer with `Requires=`, `Wants=` or `BindsTo=` on the service that it triggers. It is an info where the service
itself is for the boot (`WantedBy=multi-user.target`): it starts then anyway.

## Why it matters on a robot
Starting the timer starts the service too: the job runs at every boot, in the middle of the robot's start, and
not only at the times of OnCalendar=.

## Bad
```ini
[Unit]
Requires=backup.service

[Timer]
OnCalendar=daily
```

## Good
```ini
[Timer]
OnCalendar=daily
```

## When to ignore it
When the job is to run at boot as well; OnBootSec= says so more clearly.

## References
- systemd.timer(5), Unit=
- systemd.unit(5), Requires=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

_PULLING = ("Requires", "Wants", "BindsTo", "Upholds")


@rule("warning", fix="unsafe", silent="the service starts together with its timer without a message")
def timer_requires_service(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        if unit.type != "timer":
            continue
        service = str(unit.get("Unit", "Timer") or f"{unit.stem}.service")
        triggered = robot.units.find(service, near=unit)
        at_boot = triggered is not None and any(True for _ in robot.units.wanted_by(triggered))
        for key in _PULLING:
            for line, word in unit.naming(key, service):
                yield finding(
                    word,
                    f"{key}= starts {service} together with {unit.name}: the job runs at every boot too",
                    advice="remove it: a timer starts its service by itself",
                    severity="info" if at_boot else None,
                    fix=fix("remove it", line.without(word)),
                )
