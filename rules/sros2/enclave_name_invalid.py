"""An enclave name that rcl does not accept.

## What it finds
A name behind `--enclave`, or in `ROS_SECURITY_ENCLAVE_OVERRIDE`, that is not absolute or not a valid namespace.

## Why it matters on a robot
The process ends at start: `Enclave name is not valid`.

## Bad
```sh
ros2 run lawn driver --ros-args --enclave lawn/driver
```

## Good
```sh
ros2 run lawn driver --ros-args --enclave /lawn/driver
```

## References
- rcl, security.c; tried with the real rcl of Jazzy
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Enclave name is not valid"])
def enclave_name_invalid(robot: Robot):
    for name in robot.sros2.selected:
        if re.fullmatch(r"/|(?:/[A-Za-z_][A-Za-z0-9_]*)+", name) or not name:
            continue
        right = f"/{name.strip('/')}"
        valid = re.fullmatch(r"(?:/[A-Za-z_][A-Za-z0-9_]*)+", right)
        yield finding(
            name,
            f"'{name}' is not a valid enclave name: the process ends at start",
            advice=f"write {right}" if valid else "write an absolute name such as /lawn/driver",
            fix=fix(f"write {right}", (name, right)) if valid else None,
        )
