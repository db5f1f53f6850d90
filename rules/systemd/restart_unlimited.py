"""A start limit that never stops a crash loop, or that leaves the service down for good.

## What it finds
A service with Restart= and a start limit that acts too late or too early:

- The unit sets a limit that can never trip: StartLimitBurst= × RestartSec= > StartLimitIntervalSec=. The setting
  has no effect, and a failing service restarts forever. With a delay of 60 s or more it is an info.
- The limit is disabled, and the service restarts more than once a second, forever.
- The unit sets no limit, and the default of 5 starts in 10 s never trips (RestartSec=3 alone is enough). It is one
  finding for all such services of the robot. With Restart=always it is a warning in two cases: the unit starts ROS or a
  program that no package of the distribution brings, or it says what is to happen when it fails (OnFailure=,
  FailureAction=, StartLimitAction=), which never comes. Endless retries of other services are often wanted: they are
  an info. So are both with a delay of 60 s or more, and a program that only connects to a board, a clock or another
  computer (a micro-ROS agent, rosbridge).
- The limit is disabled on purpose. It is an info.
- The limit trips only if every start fails almost at once. It is an info.
- The opposite: Restart=always with less than a second between restarts and no limit of its own. The default
  limit trips after about a second, and the service stays down for good. It is a warning for services that start ROS
  or containers, one for all of the robot, and an info for others. What takes longer to fail, such as `ros2 launch` and
  an attached `docker compose up`, restarts forever without a pause instead.

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

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import CrashLoop
from bringup_lint.api.systemd import Outcome
from bringup_lint.api.systemd import crash_loops
from bringup_lint.api.systemd import duration
from bringup_lint.api.systemd import sufficient_limit


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "Start request repeated too quickly",
        "Failed with result 'start-limit-hit'",
        "Scheduled restart job, restart counter is at",
        "(Result: start-limit-hit)",
    ],
)
def restart_unlimited(robot: Robot) -> Iterator[Finding]:
    for crash, others in crash_loops(robot.units, robot.purpose):
        also = [note(other.place, f"{other.unit.name} as well") for other in others]
        yield finding(
            crash.place,
            _message(robot, crash),
            advice=_advice(crash),
            related=[*_settings(crash), *also],
            fix=_limit([each for each in (crash, *others) if each.unit.editable]),
            severity="warning" if crash.loop.is_unwanted else "info",
            confidence="high" if crash.policy.never_trips else "medium",
        )


def _advice(crash: CrashLoop) -> str:
    policy = crash.policy
    if crash.loop.outcome in (Outcome.GIVES_UP, Outcome.EITHER):
        return "set RestartSec= to a few seconds, and StartLimitIntervalSec= and StartLimitBurst= in [Unit] on purpose"
    return (
        f"set StartLimitIntervalSec= above {duration(policy.loop())} plus the time that "
        f"{sufficient_limit(policy).burst} starts take to fail, and StartLimitBurst=, both in [Unit]"
    )


def _message(robot: Robot, crash: CrashLoop) -> str:
    unit, policy, loop = crash
    name, every, interval = unit.name, duration(policy.longest), duration(policy.interval)
    limit = f"{policy.burst} starts in {interval}"
    if loop.outcome is Outcome.NO_LIMIT:
        return f"The start limit is disabled: a failing {name} restarts every {every} forever"
    if loop.outcome is Outcome.NEVER_TRIPS:
        delays = (
            f"delays that add up to {duration(policy.loop())}"
            if policy.steps
            else f"RestartSec={every.replace(' ', '')}"
        )
        handler = next(iter(unit.values("OnFailure", "Unit")), None) if robot.units.fails_each_time(unit) else None
        end = (
            f", and systemd {robot.target.systemd} starts {handler} after every single failure"
            if handler
            else " and never counts as failed"
        )
        return (
            f"systemd's start limit ({limit}) can never be reached with {delays}: a failing {name} is restarted "
            f"forever{end}"
        )
    if loop.outcome is Outcome.NO_TIME_LEFT:
        return f"{policy.burst} restarts × {every} fill the interval of {interval}: the limit never trips"
    if loop.outcome is Outcome.EITHER:
        return (
            f"{name} restarts after {every} without a limit of its own: where each start fails within "
            f"{duration(round(crash.spare, 2))}, it stays down for good after {policy.burst}, and else it restarts "
            "forever without a pause"
        )
    if loop.outcome is Outcome.GIVES_UP:
        return (
            f"{name} restarts after {every} without a limit of its own: after {limit}, "
            "the default, it stays down for good"
        )
    return (
        f"The default limit of {limit} trips only if every start fails within "
        f"{duration(round(crash.spare, 2))}: otherwise {name} restarts forever"
    )


def _settings(crash: CrashLoop) -> list[Related]:
    policy = crash.policy
    lines = [
        (policy.restart_at, "enables the restarts"),
        (policy.delay_at, "the delay"),
        (policy.interval_at, "the interval of the limit"),
        (policy.burst_at, "the starts that the limit allows"),
    ]
    return [note(at, text) for at, text in lines if at is not None and at is not crash.cause]


def _limit(crashes: list[CrashLoop]) -> Fix | None:
    limits = [(sufficient_limit(each.policy), each) for each in crashes]
    edits = [edit for limit, each in limits for edit in limit.edits(each.unit, each.policy)]
    shown = ", ".join(dict.fromkeys(f"{limit.burst} starts in {limit.interval} s" for limit, _ in limits))
    return fix(f"allow {shown}", *edits, safe=False) if edits else None
