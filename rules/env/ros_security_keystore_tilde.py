"""The path of the keystore is not expanded.

## What it finds
`~` or `$HOME` in ROS_SECURITY_KEYSTORE where nothing expands it, such as an environment file.

## Why it matters on a robot
rcl looks for a folder with exactly this name. With Enforce no node starts, otherwise all nodes run unsecured.

## Bad
```sh
ROS_SECURITY_KEYSTORE=~/keystore
```

## Good
```sh
ROS_SECURITY_KEYSTORE=/etc/robot/keystore
```

## When to ignore it
When a shell reads the file and exports the expanded value before a node starts.

## References
- rcl, `security.c`: the values are compared letter by letter
- https://docs.ros.org/en/rolling/Tutorials/Advanced/Security/The-Keystore.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

ORIGINS = ("Environment=", "EnvironmentFile=", "env_file:", "SetEnvironmentVariable", "additional_env", "env")
"""Who reads the place without a shell; the last three are launch's."""


@rule("error", symptoms=["SECURITY ERROR: directory '~"])
def ros_security_keystore_tilde(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.settings:
        if setting.name != "ROS_SECURITY_KEYSTORE" or setting.origin not in ORIGINS:
            continue
        if re.match(r"~|\$\{?HOME\b", setting.value):
            yield finding(
                setting.value,
                f"'{setting.value}' is not expanded here: rcl finds no keystore",
                advice="write the absolute path",
            )
