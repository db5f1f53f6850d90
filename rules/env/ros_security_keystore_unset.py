"""Security is enabled without a keystore.

## What it finds
A process with ROS_SECURITY_ENABLE=true and no ROS_SECURITY_KEYSTORE, when all sources of its environment are known.

## Why it matters on a robot
With Enforce every node exits with "failed to initialize rcl: error not set", which does not name the cause. With
Permissive all nodes run unsecured.

## Bad
```sh
ROS_SECURITY_ENABLE=true
```

## Good
```sh
ROS_SECURITY_ENABLE=true
ROS_SECURITY_KEYSTORE=/etc/robot/keystore
```

## When to ignore it
When a wrapper that the linter cannot read sets the variable.

## References
- rcl, `security.c`: the values are compared letter by letter
- https://docs.ros.org/en/rolling/Tutorials/Advanced/Security/The-Keystore.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["failed to initialize rcl: error not set"])
def ros_security_keystore_unset(robot: Robot) -> Iterator[Finding]:
    for process in robot.ros.processes:
        enable = process.environment.get("ROS_SECURITY_ENABLE")
        if enable and enable.text == "true" and robot.sros2.is_unset(process, "ROS_SECURITY_KEYSTORE"):
            yield finding(
                enable.value,
                f"{process.name} has no ROS_SECURITY_KEYSTORE: with Enforce no node starts, else all run unsecured",
                advice="set ROS_SECURITY_KEYSTORE to the absolute path of the keystore",
                related=[note(process.where, f"{process.name} gets the variable")],
            )
