"""A job that prepares a service starts at the same time as the service.

## What it finds
A service with `Type=oneshot` that [Install] makes another service pull in (`WantedBy=` or `RequiredBy=` of a .service),
when neither of the two is ordered before the other. Silent for jobs that only tell somebody that it started.

## Why it matters on a robot
`WantedBy=` is no order. systemd starts both at once: sometimes the driver finds the interface, the file or the device
as the job leaves it, and sometimes as it was before. Which of the two is first changes from boot to boot.

## Bad
```ini
[Unit]
Description=Bit rate of can0

[Service]
Type=oneshot
ExecStart=/opt/rover/bin/can-setup

[Install]
WantedBy=base-driver.service
```

## Good
```ini
[Unit]
Description=Bit rate of can0
Before=base-driver.service

[Service]
Type=oneshot
ExecStart=/opt/rover/bin/can-setup

[Install]
WantedBy=base-driver.service
```

## When to ignore it
When the job has nothing to do with what the service does at its start.

## References
- systemd.unit(5), "WantedBy=", "Before="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api import systemd

TELLS = regex(r"(?:.*/)?(?:logger|echo|true|curl|mail|sendmail|wall|notify-send|[\w.-]*notif[\w.-]*)")
"""Programs that prepare nothing for a service."""


@rule("warning", silent="units without an order start at once")
def job_not_before(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.services:
        kind = unit.get("Type")
        if kind != "oneshot" or unit.unsure_of("After", "Before"):
            continue
        programs = [process.program for process in units.started(unit)]
        if programs and all(map(TELLS.fullmatch, programs)):
            continue
        for name, _, word in units.wanted_by(unit):
            if not name.endswith(".service") or not systemd.is_unit_name(word) or name == unit.name:
                continue
            other = units.find(name, unit)
            if units.ordered(unit, name) or (other and (other.masked or other.unsure_of("After", "Before"))):
                continue
            yield finding(
                word,
                f"{name} starts {unit.name} and does not wait for it: both start at the same time, and what the job "
                "prepares may come too late",
                advice=f"add Before={name} to [Unit]",
                related=[note(kind, "a job that ends")],
            )
