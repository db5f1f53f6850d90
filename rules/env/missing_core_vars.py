"""A ROS process uses the default domain or middleware.

## What it finds
A unit that runs ROS 2 and does not set ROS_DOMAIN_ID or RMW_IMPLEMENTATION, when all sources of its environment are
known.

## Why it matters on a robot
The process joins domain 0 with the default middleware, together with every other robot and laptop on the network.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch robot_base base.launch.py'
```

## Good
```ini
[Service]
EnvironmentFile=/etc/robot/ros.env
```

## When to ignore it
When the robot is alone on its network and the defaults are intended.

## References
- https://docs.ros.org/en/rolling/Concepts/Intermediate/About-Domain-ID.html
- https://github.com/CMU-cabot/cabot/issues/160
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

CORE = ("ROS_DOMAIN_ID", "RMW_IMPLEMENTATION")


@rule("info", silent="the defaults apply without a message")
def missing_core_vars(robot: Robot) -> Iterator[Finding]:
    for process in robot.ros.processes:
        missing = [name for name in CORE if process.environment.defines(name) is False]
        if process.unit in robot.units.ros and missing and process.source.judged:
            yield finding(
                process.where,
                f"{process.name} does not set {' and '.join(missing)}: it runs with the defaults",
                advice="set them in an environment file that all units of the robot read",
            )
