"""ROS_SECURITY_ENABLE is not exactly true, so security is off.

## What it finds
`TRUE`, `True`, `1`, `yes`, `on` and other values that look like yes. `env/ros-security-disabled` handles the values
that mean no.

## Why it matters on a robot
rcl compares the text with `true`. Everything else means off, without any warning: the nodes communicate
unencrypted, and anybody on the network can drive the robot.

## Bad
```sh
ROS_SECURITY_ENABLE=TRUE
```

## Good
```sh
ROS_SECURITY_ENABLE=true
```

## When to ignore it
Never: rcl accepts only `true`.

## References
- rcl, `security.c`: the values are compared letter by letter
- https://docs.ros.org/en/rolling/Tutorials/Advanced/Security/The-Keystore.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

NO = ("", "false", "0", "no", "off")


@rule(
    "error",
    fix="unsafe",
    silent='rcl compares the value with "true" and goes on without security and without a message',
    tags=["CWE-1188", "CWE-319"],
)
def ros_security_enable_case(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("ROS_SECURITY_ENABLE"):
        if setting.text != "true" and setting.text.lower() not in NO:
            yield finding(
                setting.value,
                f"ROS_SECURITY_ENABLE '{setting.text}' disables security: the nodes communicate unencrypted",
                advice="write true, in lower case",
                fix=fix("write true", (setting.value, "true")),
            )
