"""A start limit that never stops a crash loop, or that leaves the service down for good.

## What it finds
A service with Restart= and a start limit that acts too late or too early:

- The unit sets a limit that can never trip: StartLimitBurst= × RestartSec= > StartLimitIntervalSec=. The setting
  has no effect, and a failing service restarts forever. With a delay of 60 s or more it is an info.
- The limit is disabled, and the service restarts more than once a second, forever.
- The unit sets no limit, and the default of 5 starts in 10 s never trips (RestartSec=3 alone is enough). With
  Restart=always it is a warning, one for all services of the robot. With Restart=on-failure, or a delay of 60 s or
  more, endless retries are often wanted: it is an info.
- The limit is disabled on purpose. It is an info.
- The limit trips only if every start fails almost at once. It is an info.
- The opposite: Restart=always with less than a second between restarts and no limit of its own. The default
  limit trips after about a second, and the service stays down for good. It is a warning for ROS services, and
  an info for others.

systemd ignores StartLimitIntervalSec= in [Service]: systemd/key-in-wrong-section reports that line, and this rule
is silent.

## Why it matters on a robot
A driver whose device is missing restarts forever. It fills the journal, takes CPU time from the other
services and makes the device twitch. It never reaches "failed", so that no alarm is raised and OnFailure= may
never run. A driver whose default limit trips after a second stays down after the first loose cable, until
somebody logs in.

## Bad
```ini
[Unit]
StartLimitIntervalSec=20
StartLimitBurst=5

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
from typing import NamedTuple

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Place
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Loop
from bringup_lint.api.systemd import Outcome
from bringup_lint.api.systemd import RestartPolicy
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import duration
from bringup_lint.api.systemd import restart_loop


class Crash(NamedTuple):
    """A service, and what becomes of it when it fails again and again."""

    unit: Unit
    policy: RestartPolicy
    loop: Loop


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "Start request repeated too quickly",
        "Failed with result 'start-limit-hit'",
        "Scheduled restart job, restart counter is at",
    ],
)
def restart_unlimited(robot: Robot) -> Iterator[Finding]:
    loops = list(_loops(robot))
    by_default = [each for each in loops if _rests_on_default(each)]
    for each in loops:
        if each not in by_default:
            yield _finding(each, [])
        elif each is by_default[0]:
            yield _finding(each, by_default[1:])


def _loops(robot: Robot) -> Iterator[Crash]:
    for unit in robot.units.services:
        policy = robot.units.restart(unit)
        loop = restart_loop(unit, policy, robot.units)
        if loop is not None:
            yield Crash(unit, policy, loop)


def _rests_on_default(crash: Crash) -> bool:
    """Whether the default limit is what a service counts on, the same cause in all such services of a robot."""
    return crash.loop.outcome is Outcome.NEVER_TRIPS and crash.loop.is_unwanted and not crash.policy.own_limit


def _finding(crash: Crash, others: list[Crash]) -> Finding:
    unit, policy, loop = crash
    where = _where(policy) or unit.where
    also = [note(_where(other.policy) or other.unit.where, f"{other.unit.name} as well") for other in others]
    return finding(
        where,
        _message(loop, policy, unit),
        advice=_advice(loop, policy),
        related=[*_parts(policy, where), *also],
        fix=_limit(unit, policy) if unit.editable else None,
        severity="warning" if loop.is_unwanted else "info",
        confidence="high" if policy.never_trips else "medium",
    )


def _advice(loop: Loop, policy: RestartPolicy) -> str:
    if loop.outcome is Outcome.GIVES_UP:
        return "set RestartSec= to a few seconds, and StartLimitIntervalSec= and StartLimitBurst= in [Unit] on purpose"
    return (
        f"set StartLimitIntervalSec= above {duration(policy.loop())} plus the time that "
        f"{policy.burst or 5} starts take to fail, and StartLimitBurst=, both in [Unit]"
    )


def _where(policy: RestartPolicy) -> Place | None:
    """The line that switches the limit off, else the one that enables the restarts."""
    if policy.never_trips and policy.interval_at and not policy.interval:
        return policy.interval_at
    if policy.never_trips and policy.burst_at and not policy.burst:
        return policy.burst_at
    return policy.restart_at


def _message(loop: Loop, policy: RestartPolicy, unit: Unit) -> str:
    name, every, interval = unit.name, duration(policy.longest), duration(policy.interval)
    limit = f"{policy.burst} starts in {interval}"
    if loop.outcome is Outcome.NO_LIMIT:
        return f"The start limit is disabled: a failing {name} restarts every {every} forever"
    if loop.outcome is Outcome.NEVER_TRIPS:
        sums = "The first {0} delays take {2}" if policy.steps else "{0} restarts × {1} = {2}"
        sums = sums.format(policy.burst, every, duration(policy.loop()))
        return f"{sums} > {interval}: the start limit never trips, a failing {name} restarts forever"
    if loop.outcome is Outcome.NO_TIME_LEFT:
        return f"{policy.burst} restarts × {every} fill the interval of {interval}: the limit never trips"
    if loop.outcome is Outcome.GIVES_UP:
        return (
            f"{name} restarts after {every} without a limit of its own: after {limit}, "
            "the default, it stays down for good"
        )
    spare = (policy.interval - policy.loop()) / policy.burst
    return (
        f"The default limit of {limit} trips only if every start fails within "
        f"{duration(round(spare, 2))}: otherwise {name} restarts forever"
    )


def _parts(policy: RestartPolicy, where: Place) -> list[Related]:
    lines = [
        (policy.restart_at, "enables the restarts"),
        (policy.delay_at, "the delay"),
        (policy.interval_at, "the interval of the limit"),
        (policy.burst_at, "the starts that the limit allows"),
    ]
    return [note(at, text) for at, text in lines if at is not None and at is not where]


def _limit(unit: Unit, policy: RestartPolicy) -> Fix | None:
    burst = policy.burst or 5
    span = math.ceil(burst * (policy.longest + 10) / 30) * 30
    edits: list[tuple[Place, str]] = []
    missing = []
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
