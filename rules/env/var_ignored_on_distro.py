"""The distribution does not read this variable.

## What it finds
Variables that the robot's distribution does not read: discovery range and static peers before Iron, variables of
rmw_zenoh before Humble, and `RCUTILS_CONSOLE_STDOUT_LINE_BUFFERED`, which nothing reads any more.

## Why it matters on a robot
The setting has no effect, and no message says so: discovery, for example, stays as wide as it was.

## Bad
```sh
ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST      (on Humble)
```

## Good
```sh
ROS_LOCALHOST_ONLY=1
```

## When to ignore it
When the same file also serves robots with a distribution that reads the variable.

## References
- rcl of each distribution
- https://docs.ros.org/en/rolling/Tutorials/Advanced/Improved-Dynamic-Discovery.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least

SINCE = {
    "ROS_AUTOMATIC_DISCOVERY_RANGE": ("iron", "use ROS_LOCALHOST_ONLY"),
    "ROS_STATIC_PEERS": ("iron", "name the peers in the DDS configuration"),
    "ZENOH_ROUTER_CONFIG_URI": ("humble", "rmw_zenoh exists from Humble on"),
    "ZENOH_SESSION_CONFIG_URI": ("humble", "rmw_zenoh exists from Humble on"),
    "ZENOH_CONFIG_OVERRIDE": ("humble", "rmw_zenoh exists from Humble on"),
}
GONE = {"RCUTILS_CONSOLE_STDOUT_LINE_BUFFERED": "use RCUTILS_LOGGING_BUFFERED_STREAM"}


@rule("warning")
def var_ignored_on_distro(robot: Robot) -> Iterator[Finding]:
    if robot.target.ros is None:
        return
    for setting in robot.ros.settings:
        since, instead = SINCE.get(setting.name, ("", GONE.get(setting.name, "")))
        if setting.name in GONE or (since and at_least(robot.target.ros, since) is False):
            yield finding(
                setting.value,
                f"{robot.target.ros} does not read {setting.name}: it has no effect",
                advice=instead,
            )
