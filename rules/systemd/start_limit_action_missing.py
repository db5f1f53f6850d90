"""After the start limit, the service stays down and nothing raises an alarm.

## What it finds
A ROS service whose start limit can trip, and that has neither OnFailure= nor StartLimitAction=.

## Why it matters on a robot
When the limit trips, the service stays "failed" until somebody runs `systemctl reset-failed`. A robot in the
field should at least raise an alarm, stop its actuators or reboot.

## Bad
```ini
[Unit]
StartLimitIntervalSec=90
StartLimitBurst=5
```

## Good
```ini
[Unit]
StartLimitIntervalSec=90
StartLimitBurst=5
OnFailure=robot-alarm.service
```

## When to ignore it
When monitoring outside of systemd detects the failed unit, or when the robot can do without the service.

## References
- systemd.unit(5), StartLimitAction= and OnFailure=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import duration


@rule("info", symptoms=["Start request repeated too quickly", "Failed with result 'start-limit-hit'"])
def start_limit_action_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        policy = robot.units.restart(unit)
        if (
            not unit.complete
            or not policy.restarts
            or not policy.limited
            or policy.never_trips
            or policy.leaves_no_time
        ):
            continue
        action = unit.get("StartLimitAction", "Unit") or unit.get("StartLimitAction", "Service")
        if unit.has("OnFailure") or unit.has("OnFailure", "Service") or (action and action != "none"):
            continue
        yield finding(
            policy.burst_at or policy.interval_at or policy.where,
            f"After {policy.burst} starts in {duration(policy.interval)} {unit.name} stays down until "
            "somebody runs systemctl reset-failed, and nothing raises an alarm",
            advice="name a handler with OnFailure= in [Unit], or an action with StartLimitAction=",
            related=[note(policy.where, "enables the restarts")],
        )
