"""ROS_SECURITY_ENABLE is not exactly true: security is off.

## What it finds
TRUE, True, 1, yes, on or another spelling of yes. Clear negatives are the business of env/ros-security-disabled.

## Why it matters on a robot
rcl compares the text with `true`. Everything else means off, without any warning: the nodes talk in clear text, and
anybody on the network can drive the robot.

## Bad
```sh
ROS_SECURITY_ENABLE=TRUE
```

## Good
```sh
ROS_SECURITY_ENABLE=true
```

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


@rule("error", fix="safe", tags=["CWE-1188", "CWE-319"])
def ros_security_enable_case(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("ROS_SECURITY_ENABLE"):
        if setting.text != "true" and setting.text.lower() not in NO:
            yield finding(
                setting.value,
                f"ROS_SECURITY_ENABLE '{setting.text}' switches security off: the nodes talk in clear text",
                advice="write true, in small letters",
                fix=fix("write true", (setting.value, "true")),
            )
