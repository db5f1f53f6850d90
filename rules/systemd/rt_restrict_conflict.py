"""RestrictRealtime= forbids the real-time priority that the unit requests.

## What it finds
RestrictRealtime=yes together with one of these settings:

- error: LimitRTPRIO=, because the service can never use it;
- warning: CPUSchedulingPolicy=fifo or rr. systemd starts the process with that policy, but the process cannot
  set one for its threads.

## Why it matters on a robot
The kernel rejects the control loop's request for real-time priority. The loop runs with the jitter of an
ordinary process.

## Bad
```ini
[Service]
ExecStart=/opt/ros/jazzy/lib/controller_manager/ros2_control_node
LimitRTPRIO=99
RestrictRealtime=yes
```

## Good
```ini
[Service]
ExecStart=/opt/ros/jazzy/lib/controller_manager/ros2_control_node
LimitRTPRIO=99
```

## When to ignore it
The warning, when the process needs no policy other than the one that systemd gives it at the start.

## References
- systemd.exec(5), RestrictRealtime=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=["sched_setscheduler: Operation not permitted", "Could not enable FIFO RT scheduling policy"],
)
def rt_restrict_conflict(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        restricted = unit.flag("RestrictRealtime")
        if not restricted:
            continue
        policy, limit = unit.get("CPUSchedulingPolicy"), unit.get("LimitRTPRIO")
        if limit and limit.partition(":")[0] != "0":
            yield finding(
                limit,
                f"RestrictRealtime= forbids every real-time priority, so LimitRTPRIO={limit} has no "
                f"effect on {unit.name}",
                advice="remove RestrictRealtime= or the limit",
                related=[note(restricted.where, "forbids real-time scheduling")],
            )
        elif policy in ("fifo", "rr"):
            yield finding(
                policy,
                f"{unit.name} starts with {policy} scheduling, but RestrictRealtime= prevents it from setting "
                "a real-time policy for its threads",
                advice="remove RestrictRealtime=",
                related=[note(restricted.where, "forbids real-time scheduling")],
                severity="warning",
            )
