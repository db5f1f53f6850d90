"""ROS_LOCALHOST_ONLY is deprecated since Iron.

## What it finds
ROS_LOCALHOST_ONLY on a robot that runs Iron or newer, as info. If the same file also sets a discovery range or
static peers, which it overrides, the finding is a warning.

## Why it matters on a robot
Every process logs two warnings. `ROS_LOCALHOST_ONLY=1` overrides ROS_AUTOMATIC_DISCOVERY_RANGE and
ROS_STATIC_PEERS: the machines that are named there are never found.

## Bad
```sh
ROS_LOCALHOST_ONLY=1
```

## Good
```sh
ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST
```

## When to ignore it
When the same file also serves robots that still run Humble.

## References
- https://github.com/ros2/rcl/pull/1023
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least


@rule("info", symptoms=["ROS_LOCALHOST_ONLY is deprecated"])
def ros_localhost_only_deprecated(robot: Robot) -> Iterator[Finding]:
    if not at_least(robot.target.ros, "iron"):
        return
    others = robot.ros.of("ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_STATIC_PEERS")
    for setting in robot.ros.of("ROS_LOCALHOST_ONLY"):
        same = [other for other in others if other.value.span.source is setting.value.span.source]
        overrides = setting.text.startswith("1") and bool(same)
        yield finding(
            setting.value,
            f"ROS_LOCALHOST_ONLY overrides {same[0].name}"
            if overrides
            else f"ROS_LOCALHOST_ONLY is deprecated in {robot.target.ros}: every process warns twice",
            advice="use ROS_AUTOMATIC_DISCOVERY_RANGE=" + ("LOCALHOST" if setting.text.startswith("1") else "SUBNET"),
            related=[note(other.value, "set here, without effect") for other in same if overrides],
            severity="warning" if overrides else None,
        )
