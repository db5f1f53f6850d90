"""SROS2 is disabled although the robot has a keystore.

## What it finds
`false`, `0`, `no` or `off` in the ROS_SECURITY_ENABLE of a file that also names a keystore. Files for tests,
simulation and development are not reported.

## Why it matters on a robot
Any machine on the network can publish velocity commands. Security that is switched off for a test tends to stay
off.

## Bad
```sh
ROS_SECURITY_ENABLE=false
ROS_SECURITY_KEYSTORE=/etc/robot/keystore
```

## Good
```sh
ROS_SECURITY_ENABLE=true
ROS_SECURITY_STRATEGY=Enforce
ROS_SECURITY_KEYSTORE=/etc/robot/keystore
```

## When to ignore it
When this file is for commissioning and is not installed on the delivered robot.

## References
- rcl, `security.c`: the values are compared letter by letter
- https://docs.ros.org/en/rolling/Tutorials/Advanced/Security/The-Keystore.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

NO = ("false", "0", "no", "off")


@rule("error", fix="unsafe", silent="nodes start without security and without a message", tags=["CWE-306", "CWE-319"])
def ros_security_disabled(robot: Robot) -> Iterator[Finding]:
    stores = robot.ros.of("ROS_SECURITY_KEYSTORE")
    for setting in robot.ros.of("ROS_SECURITY_ENABLE"):
        if setting.text.lower() not in NO or robot.ros.is_development(setting.value):
            continue
        for store in stores:
            if store.value.span.source is setting.value.span.source:
                yield finding(
                    setting.value,
                    "SROS2 is disabled: any machine on the network can command the robot",
                    advice="write ROS_SECURITY_ENABLE=true and ROS_SECURITY_STRATEGY=Enforce",
                    related=[note(store.value, "the keystore is named here")],
                    fix=fix("enable security", (setting.value, "true"), safe=False),
                )
                break
