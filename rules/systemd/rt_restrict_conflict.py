"""RestrictRealtime= forbids what the unit asks for.

## What it finds
RestrictRealtime=yes together with LimitRTPRIO= (an error: the permission can never be used) or with
CPUSchedulingPolicy=fifo or rr (a warning: systemd still starts the process with that policy, but the
process may not choose one for its threads).

## Why it matters on a robot
The control loop asks for its real-time priority, is refused, and runs with the jitter of an ordinary
process.

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

## References
- systemd.exec(5), RestrictRealtime=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import flag


@rule(
    "error",
    symptoms=["Could not enable FIFO RT scheduling policy", "sched_setscheduler: Operation not permitted"],
)
def rt_restrict_conflict(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        restricted = flag(unit, "RestrictRealtime")
        if not restricted.value:
            continue
        policy, limit = unit.get("CPUSchedulingPolicy"), unit.get("LimitRTPRIO")
        if limit and limit.partition(":")[0] != "0":
            yield finding(
                limit,
                f"RestrictRealtime= refuses every real-time priority, so LimitRTPRIO={limit} is of no "
                f"use to {unit.name}",
                advice="drop RestrictRealtime= or the limit",
                related=[note(restricted.at, "refuses real-time scheduling")],
            )
        elif policy in ("fifo", "rr"):
            yield finding(
                policy,
                f"{unit.name} starts with {policy} scheduling, but RestrictRealtime= refuses it any "
                "policy for its own threads",
                advice="drop RestrictRealtime=",
                related=[note(restricted.at, "refuses real-time scheduling")],
                severity="warning",
            )
