"""ROS_DOMAIN_ID is no number: no node starts.

## What it finds
A value of ROS_DOMAIN_ID from which no number can be read, such as a name or a number that kept its quotes.

## Why it matters on a robot
rcl refuses to initialise: every process of ROS exits at start.

## Bad
```sh
ROS_DOMAIN_ID=lab
```

## Good
```sh
ROS_DOMAIN_ID=42
```

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
                f"rcl reads no number in ROS_DOMAIN_ID '{setting.text}': every ROS process exits at start",
                advice="write a plain decimal number from 0 to 101",
            )
