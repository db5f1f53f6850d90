"""The start check may wait longer than systemd allows.

## What it finds
A command in ExecStartPre= whose loops and sleeps add up to more than TimeoutStartSec=. The rule reads them
from the shell text, or from the script in the tree. A typical case is a timeout per device in a loop over
several devices. ExecStart= is also checked in services such as Type=notify and oneshot, whose start ends only
when the program reports readiness or exits.

systemd restarts the timer for every command of the unit.

## Why it matters on a robot
systemd kills the check before it can say which device is missing. The journal only shows that the start timed
out.

## Bad
```ini
[Service]
TimeoutStartSec=60
# waits up to 30 s for each of four devices
ExecStartPre=/usr/local/bin/wait-for-devices
```

## Good
```ini
[Service]
TimeoutStartSec=150
ExecStartPre=/usr/local/bin/wait-for-devices
```

## When to ignore it
When the longest wait never happens, for example because the loop ends early or the devices appear in
parallel.

## References
- systemd.service(5), TimeoutStartSec= and ExecStartPre=
- systemd, src/core/service.c: service_run_next_control() arms the timer for each command
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import duration

BEFORE = ("ExecCondition", "ExecStartPre")


@rule("warning", symptoms=["start-pre operation timed out. Terminating."])
def timeout_start_short(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        service = robot.units.supervision(unit)
        limit = service.start_timeout
        if not unit.complete or limit.value is None or service.type.unknown:
            continue
        counted = BEFORE if service.type.value in ("simple", "exec", "idle") else (*BEFORE, "ExecStart")
        for process in robot.units.processes(unit):
            wait = robot.units.longest_wait(process) if process.key in counted else None
            if wait is None or wait.seconds <= limit.value:
                continue
            sum_ = (
                f"{wait.times} × {duration(wait.each)} = "
                if wait.times > 1 and wait.times * wait.each == wait.seconds
                else ""
            )
            default = "" if limit.at else " (the default)"
            yield finding(
                limit.at or process.program,
                f"{process.name} may wait {sum_}{duration(wait.seconds)}, but TimeoutStartSec= is "
                f"{duration(limit.value)}{default}: systemd kills it before it can say what is missing",
                advice=f"set TimeoutStartSec= above {duration(wait.seconds)}",
                related=[
                    *([note(process.program, "the command that waits")] if limit.at else ()),
                    *([note(wait.where, "it waits here")] if wait.where and wait.where.source.name else ()),
                ],
            )
