"""A Type=notify service in which no process reports readiness.

## What it finds
A ROS service with Type=notify and NotifyAccess=all (or exec) whose launched packages are all in the tree and
never notify systemd. Either no package contains sd_notify, systemd-notify or NOTIFY_SOCKET, or only a node
does that the launch file does not start.

## Why it matters on a robot
systemd waits for READY=1, gives up after TimeoutStartSec= and kills nodes that were running well.

## Bad
```ini
[Service]
Type=notify
NotifyAccess=all
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## Good
```ini
[Service]
Type=exec
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## When to ignore it
When a library that is not in the tree sends READY=1.

## References
- sd_notify(3); systemd.service(5), Type=notify
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import duration


@rule(
    "warning",
    confidence="medium",
    symptoms=["start operation timed out. Terminating."],
    aliases=["node/sd-notify-missing"],
)
def notify_nobody_notifies(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        if not unit.complete or not service.notifies or service.access.value not in ("all", "exec"):
            continue
        if service.process is None or service.process.opaque or robot.notify.in_process(service.process):
            continue
        programs = [found for _, found in service.process.ros if found.kind in ("launch", "run")]
        silent = [found for program in programs if (found := robot.notify.silent_launch(program))]
        if not silent or len(silent) < len(programs):
            continue
        idle = silent[0].idle
        if idle:
            why = f"the launch file does not start {idle[0].basename}"
        else:
            why = "no code in the tree notifies systemd"
        limit = service.start_timeout.value
        yield finding(
            service.type.at or unit.where,
            f"Nothing that {unit.name} starts sends READY=1 ({why}): the start times out"
            + (f" after {duration(limit)}" if limit and limit < 1e9 else ""),
            advice="use Type=exec, or launch a node that reports readiness",
            related=[
                *(note(found.where, "the unit starts this") for found in programs),
                *(note(source, "would notify, but nothing starts it") for source in idle[:3]),
            ],
        )
