"""A start limit that never stops a crash loop, or that leaves the service down for good.

## What it finds
A service with Restart= and a start limit that acts too late or too early:

- The limit can never trip, so that a failing service restarts forever. Either it is disabled, or its interval
  is shorter than the restarts take (StartLimitBurst= × RestartSec= > StartLimitIntervalSec=). The default is
  5 starts in 10 s, so that RestartSec=3 alone is enough. It is a warning for Restart=always, for ROS
  services, and for units with a limit of their own or OnFailure=. It is an info for other units, and for
  delays of 60 s or more.
- The limit trips only if every start fails almost at once. It is an info.
- The opposite: Restart=always with less than a second between restarts and no limit of its own. The default
  limit trips after about a second, and the service stays down for good. It is a warning for ROS services, and
  an info for others.

systemd ignores StartLimitIntervalSec= in [Service], and so does this rule.

## Why it matters on a robot
A driver whose device is missing restarts forever. It fills the journal, takes CPU time from the other
services and makes the device twitch. It never reaches "failed", so that no alarm is raised and OnFailure= may
never run. A driver whose default limit trips after a second stays down after the first loose cable, until
somebody logs in.

## Bad
```ini
[Service]
ExecStart=/opt/robot/bin/drivers
Restart=always
RestartSec=5
```

## Good
```ini
[Unit]
StartLimitIntervalSec=90
StartLimitBurst=5
OnFailure=robot-alarm.service

[Service]
ExecStart=/opt/robot/bin/drivers
Restart=always
RestartSec=5
```

## When to ignore it
When endless retries are intended and harmless, for example for a service that waits for a device that the
operator plugs in. A RestartSec= of a minute or more, or RestartSteps=, makes the loop cheap.

## References
- systemd.unit(5), StartLimitIntervalSec=; systemd.service(5), RestartSec= and RestartSteps=
- systemd, src/basic/ratelimit.c: the limit trips on start number burst + 1 within the interval
"""

import math
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import RestartPolicy
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import duration

SLOW = 60.0
"""Seconds between restarts from which a loop is a deliberate, harmless retry."""
FAILING_LAUNCH = 1.0
"""Seconds that ros2 launch needs at least to start and fail."""


@rule(
    "warning",
    fix="unsafe",
    symptoms=["Scheduled restart job, restart counter is at", "Start request repeated too quickly"],
)
def restart_unlimited(robot: Robot) -> Iterator[Finding]:
    launches = [unit for unit, _ in robot.units.launch]
    for unit in robot.units.services:
        policy = robot.units.restart(unit)
        if not unit.complete or not policy.known or not policy.restarts:
            continue
        severity, message = _verdict(policy, unit, unit in robot.units.ros, unit in launches)
        if not severity:
            continue
        off = [
            at
            for at, value in ((policy.interval_at, policy.interval), (policy.burst_at, policy.burst))
            if at and not value
        ]
        where = off[0] if off and policy.never_trips else policy.restart_at
        yield finding(
            where,
            message,
            advice=f"set StartLimitIntervalSec= above {duration(policy.loop())} plus the time that "
            f"{policy.burst or 5} starts take to fail, and StartLimitBurst=, both in [Unit]",
            related=_parts(policy, where),
            fix=_limit(unit, policy) if unit.editable and not policy.misplaced else None,
            severity=severity,
            confidence="high" if policy.never_trips else "medium",
        )


def _verdict(policy: RestartPolicy, unit: Unit, ros: bool, launch):
    name, every = unit.name, duration(policy.longest)
    if policy.never_trips:
        if policy.steps and policy.longest >= SLOW:
            return None, ""
        intended = policy.own_limit or unit.has("OnFailure")
        bad = policy.longest < SLOW and (policy.restart == "always" or ros or intended)
        if not policy.limited:
            message = f"The start limit is disabled: a failing {name} restarts every {every} forever"
        else:
            sums = "The first {0} delays take {2}" if policy.steps else "{0} restarts × {1} = {2}"
            sums = sums.format(policy.burst, every, duration(policy.loop()))
            message = (
                f"{sums} > {duration(policy.interval)}: the start limit never trips, a failing {name} restarts forever"
            )
        return "warning" if bad else "info", message
    limit = f"{policy.burst} starts in {duration(policy.interval)}"
    if policy.leaves_no_time:
        return (
            "info",
            f"{policy.burst} restarts × {every} fill the interval of {duration(policy.interval)}: the "
            "limit never trips",
        )
    if policy.interval_at or policy.burst_at or policy.misplaced:
        return None, ""
    if policy.restart == "always" and policy.delay < 1 and (ros or policy.delay):
        message = (
            f"{name} restarts after {every} without a limit of its own: after {limit}, "
            "the default, it stays down for good"
        )
        return "warning" if ros else "info", message
    if launch and policy.loop(FAILING_LAUNCH) > policy.interval:
        spare = (policy.interval - policy.loop()) / policy.burst
        return (
            "info",
            f"The default limit of {limit} trips only if every start fails within "
            f"{duration(round(spare, 2))}: otherwise {name} restarts forever",
        )
    return None, ""


def _parts(policy: RestartPolicy, where: Located | None) -> list[Related]:
    lines = [
        (policy.restart_at, "enables the restarts"),
        (policy.delay_at, "the delay"),
        (policy.interval_at, "the interval of the limit"),
        (policy.burst_at, "the starts that the limit allows"),
        *((at, "ignored: StartLimitIntervalSec= belongs in [Unit]") for at in policy.misplaced),
    ]
    return [note(at, text) for at, text in lines if at is not None and at is not where]


def _limit(unit: Unit, policy: RestartPolicy) -> Fix | None:
    burst = policy.burst or 5
    span = math.ceil(burst * (policy.longest + 10) / 30) * 30
    edits, missing = [], []
    for at, key, value in (
        (policy.interval_at, "StartLimitIntervalSec", span),
        (policy.burst_at, "StartLimitBurst", burst),
    ):
        if at is None:
            missing.append(f"{key}={value}")
        elif str(value) != at:
            edits.append((at, str(value)))
    if missing:
        edits.append(unit.new_line("Unit", "\n".join(missing)))
    return fix(f"allow {burst} starts in {span} s", *edits, safe=False) if edits else None
