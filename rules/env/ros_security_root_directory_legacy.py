"""A security variable was removed after Eloquent.

## What it finds
`ROS_SECURITY_ROOT_DIRECTORY`, `ROS_SECURITY_NODE_DIRECTORY` and `ROS_SECURITY_LOOKUP_TYPE`, wherever they are set.

## Why it matters on a robot
Since Foxy nothing reads them: the keystore that they name is not used.

## Bad
```sh
ROS_SECURITY_ROOT_DIRECTORY=/etc/lawn/keystore
```

## Good
```sh
ROS_SECURITY_KEYSTORE=/etc/lawn/keystore
```

## When to ignore it
When the same file also serves robots that still run Dashing or Eloquent.

## References
- rcl, security.c: ROS_SECURITY_KEYSTORE since Foxy
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

INSTEAD = {
    "ROS_SECURITY_ROOT_DIRECTORY": "set ROS_SECURITY_KEYSTORE",
    "ROS_SECURITY_NODE_DIRECTORY": "set ROS_SECURITY_KEYSTORE, and select an enclave with --ros-args --enclave",
    "ROS_SECURITY_LOOKUP_TYPE": "delete it: enclaves are looked up by their exact name",
}


@rule("warning", silent="rcl does not look at variables that it does not know")
def ros_security_root_directory_legacy(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.settings:
        if setting.name in INSTEAD:
            yield finding(
                setting.value,
                f"Since Foxy nothing reads {setting.name}: it has no effect",
                advice=INSTEAD[setting.name],
            )
