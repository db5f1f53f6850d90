"""A keystore is set, but security is not enabled.

## What it finds
A process whose environment sets ROS_SECURITY_KEYSTORE but not ROS_SECURITY_ENABLE, when all sources of its
environment are known.

## Why it matters on a robot
The nodes run unsecured, although everything looks as if security were set up.

## Bad
```sh
ROS_SECURITY_KEYSTORE=/etc/robot/keystore
```

## Good
```sh
ROS_SECURITY_ENABLE=true
ROS_SECURITY_STRATEGY=Enforce
ROS_SECURITY_KEYSTORE=/etc/robot/keystore
```

## When to ignore it
When security is enabled only in some deployments, by a file that is not in this tree.

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


@rule("error", silent="nodes start without security and without a message", tags=["CWE-1188"])
def ros_security_keystore_without_enable(robot: Robot) -> Iterator[Finding]:
    for process in robot.ros.processes:
        store = process.environment.get("ROS_SECURITY_KEYSTORE")
        if store and store.text and robot.sros2.is_unset(process, "ROS_SECURITY_ENABLE"):
            yield finding(
                store.value,
                f"{process.name} sets a keystore but does not enable security: its nodes run unsecured",
                advice="add ROS_SECURITY_ENABLE=true and ROS_SECURITY_STRATEGY=Enforce",
                related=[note(process.where, f"{process.name} gets the variable")],
            )
