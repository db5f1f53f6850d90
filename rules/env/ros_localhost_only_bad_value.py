"""ROS_LOCALHOST_ONLY is neither 0 nor 1.

## What it finds
A ROS_LOCALHOST_ONLY other than 0 and 1. Humble compares the whole text with 1. Newer distributions look only at the
first character.

## Why it matters on a robot
`true` and `yes` mean disabled: the robot talks to the whole network although it was meant to stay on its own
machine.

## Bad
```sh
ROS_LOCALHOST_ONLY=true
```

## Good
```sh
ROS_LOCALHOST_ONLY=1
```

## When to ignore it
When the robot is meant to talk to the network. Writing 0 says so.

## References
- rcl, `localhost.c` (Humble) and `discovery_options.c` (Jazzy)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least


@rule(
    "error",
    fix="unsafe",
    tags=["CWE-923"],
    symptoms=["'localhost_only' is disabled, 'automatic_discovery_range' and 'static_peers' will be used."],
)
def ros_localhost_only_bad_value(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("ROS_LOCALHOST_ONLY"):
        if setting.text in ("", "0", "1"):
            continue
        newer = at_least(robot.target.ros, "iron")
        enabled = setting.text.startswith("1") if newer else False
        if newer is None and setting.text.startswith("1"):
            continue
        yield finding(
            setting.value,
            f"ROS_LOCALHOST_ONLY '{setting.text}' means enabled"
            if enabled
            else f"ROS_LOCALHOST_ONLY '{setting.text}' means disabled: the robot talks to the whole network",
            advice="write 1 to stay on this machine, 0 to talk to the network",
            fix=fix("write 1", (setting.value, "1"), safe=False),
        )
