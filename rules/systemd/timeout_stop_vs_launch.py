"""TimeoutStopSec= does not fit the time that ros2 launch needs to stop its nodes.

## What it finds
A service that runs ros2 launch with a TimeoutStopSec= below 15 s or above 90 s. If the launch file is in the
tree, the `sigterm_timeout` and `sigkill_timeout` of its nodes replace the usual 5 s each. Where launch itself kills
its last node before the limit, less than 5 s of margin is an info.

## Why it matters on a robot
When launch stops, it sends every node SIGINT, SIGTERM after 5 s, and SIGKILL after another 5 s. A shorter
timeout kills launch and all nodes during this sequence, before they have reached their safe state. With a
very long one, a single hung node delays every shutdown.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
KillSignal=SIGINT
TimeoutStopSec=5
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
KillSignal=SIGINT
TimeoutStopSec=20
```

## When to ignore it
When measurements show that all nodes always stop well within the limit, or need the long one, for example to
save a large map.

## References
- systemd.service(5), TimeoutStopSec=
- launch, ExecuteProcess: sigterm_timeout and sigkill_timeout are 5 s each
"""

import math
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.supervision import StopTime
from bringup_lint.api.supervision import expansion_of
from bringup_lint.api.supervision import stop_time
from bringup_lint.api.systemd import Ros
from bringup_lint.api.systemd import duration

USUAL = 10.0
MARGIN, LONG = 5.0, 90.0


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "State 'stop-sigterm' timed out. Killing.",
        "failed to terminate * seconds after receiving *, escalating to SIGTERM",
        "failed to terminate * seconds after receiving *, escalating to SIGKILL",
        "Killing process * with signal SIGKILL.",
    ],
)
def timeout_stop_vs_launch(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        launches = robot.units.launches(unit)
        limit = service.stop_timeout
        needed, given = needs(robot, launches)
        short = needed + MARGIN
        if not launches or limit.value is None or short <= limit.value <= max(LONG, short) or service.in_container:
            continue
        if limit.at is None or unit.get("Type") == "oneshot":
            continue
        if limit.value < short:
            steps = "(SIGINT, 5 s, SIGTERM, 5 s, SIGKILL) " if not given else ""
            message = (
                f"{unit.name} is killed {duration(limit.value)} after the stop: ros2 launch alone may take "
                f"{duration(needed)} {steps}to stop its nodes"
            )
        elif limit.value == math.inf:
            message = f"One hung node of {unit.name} blocks the stop, and with it the shutdown, forever"
        else:
            message = f"One hung node of {unit.name} delays every shutdown by {duration(limit.value)}"
        own = limit.at in unit.values("TimeoutStopSec", "Service")
        yield finding(
            limit.at,
            message,
            advice=f"set TimeoutStopSec={math.ceil(needed + 2 * MARGIN)}",
            related=[
                *(note(found.where, "the unit starts ros2 launch here") for found in launches),
                *(note(value.span, "a node may take this long") for value in given),
            ],
            fix=fix(
                f"set TimeoutStopSec={math.ceil(needed + 2 * MARGIN)}",
                (limit.at, f"{math.ceil(needed + 2 * MARGIN)}"),
                safe=False,
            )
            if unit.editable and own
            else None,
            severity="info" if needed <= limit.value < short else None,
        )


def needs(robot: Robot, launches: list[Ros]) -> StopTime:
    """How long the launch files of a unit may take to stop, and the timeouts of nodes that set it."""
    expansions = [expansion_of(found, robot.launch) for found in launches] if robot.has_launch_files else []
    known = [stop_time(expansion) if expansion is not None else None for expansion in expansions]
    usual = StopTime(USUAL, [])
    return max((each or usual for each in known), key=lambda each: each.seconds, default=usual)
