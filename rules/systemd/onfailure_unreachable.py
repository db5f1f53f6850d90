"""OnFailure= never runs, because the service never enters "failed".

## What it finds
OnFailure= on a service that restarts forever because its start limit can never trip. It is a warning up to
systemd 253 and with RestartMode=direct, because the unit then enters "failed" only when the limit trips. It
is an info from systemd 254 on, which runs the handler after every single failure.

## Why it matters on a robot
The alarm, the safe stop or the log upload that OnFailure= should start never runs. Nobody notices until it is
needed.

## Bad
```ini
[Unit]
OnFailure=robot-alarm.service

[Service]
ExecStart=/opt/robot/bin/drivers
Restart=on-failure
RestartSec=5
```

## Good
```ini
[Unit]
OnFailure=robot-alarm.service
StartLimitIntervalSec=90
StartLimitBurst=5

[Service]
ExecStart=/opt/robot/bin/drivers
Restart=on-failure
RestartSec=5
```

## When to ignore it
The info, when the handler should run after every single failure.

## References
- systemd.unit(5), OnFailure=
- <https://github.com/systemd/systemd/issues/33710>: the change of behaviour in 254
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import duration


@rule("warning", silent="the service never fails, so nothing is triggered")
def onfailure_unreachable(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        policy = robot.units.restart(unit)
        handlers = [*unit.values("OnFailure", "Unit"), *unit.values("OnFailure", "Service")]
        if not handlers or not unit.complete or not policy.never_trips:
            continue
        why = (
            f"{policy.burst} restarts take {duration(policy.loop())} > {duration(policy.interval)}, so "
            "the start limit never trips"
            if policy.limited
            else "The start limit is disabled"
        )
        each_time = robot.units.fails_each_time(unit)
        yield finding(
            handlers[0],
            f"{why}: systemd {robot.target.systemd} starts {handlers[0]} after every single failure"
            if each_time
            else f'{why}: {unit.name} never enters "failed" and OnFailure= does not fire',
            advice="give the unit a start limit in [Unit] that its restarts can reach",
            related=[
                note(policy.where, "enables the restarts"),
                *([note(policy.delay_at, "the delay")] if policy.delay_at else ()),
                *([note(policy.interval_at, "the interval of the limit")] if policy.interval_at else ()),
                *(note(at, "ignored here: it belongs in [Unit]") for at in policy.misplaced),
            ],
            severity="info" if each_time else "warning",
        )
