"""ROS_DOMAIN_ID is not a number, so no node starts.

## What it finds
A ROS_DOMAIN_ID that does not begin with a number, such as a name or a number with quotes that are part of the
value.

## Why it matters on a robot
rcl refuses to initialise: every ROS process exits at start.

## Bad
```sh
ROS_DOMAIN_ID=lab
```

## Good
```sh
ROS_DOMAIN_ID=42
```

## When to ignore it
When a script replaces the value before a node starts.

## References
- rcl, `domain_id.c`: the text goes through strtoul with base 0
- https://github.com/ros2/rmw_cyclonedds/issues/61
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.ros import domain_id


@rule("error", symptoms=["ROS_DOMAIN_ID is not an integral number", "ROS_DOMAIN_ID is out of range"])
def ros_domain_id_not_integer(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("ROS_DOMAIN_ID"):
        if domain_id(setting.text).number is None:
            yield finding(
                setting.value,
                f"rcl finds no number in ROS_DOMAIN_ID '{setting.text}': every ROS process exits at start",
                advice="write a plain decimal number from 0 to 101",
            )
