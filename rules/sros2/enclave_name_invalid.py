"""An enclave name that rcl does not accept.

## What it finds
A name behind `--enclave`, or a path in a policy, that is not absolute or not a valid namespace, and a
`ROS_SECURITY_ENCLAVE_OVERRIDE` without a slash in front.

## Why it matters on a robot
With `--enclave` the process ends at start, even with security off: `Enclave name is not valid`. The variable is
not checked: its first component is cut short, and the enclave is not found.

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
    overrides = {id(setting.value) for setting in robot.ros.of("ROS_SECURITY_ENCLAVE_OVERRIDE")}
    paths = [enclave.path for policy in robot.sros2.policies for enclave in policy.enclaves if enclave.path]
    described = {id(path) for path in paths}
    for name in (*robot.sros2.selected, *paths):
        override = id(name) in overrides
        if not name or re.fullmatch(r"/|(?:/[A-Za-z_][A-Za-z0-9_]*)+", name) or (override and name.startswith("/")):
            continue
        right = f"/{name.strip('/')}"
        valid = re.fullmatch(r"(?:/[A-Za-z_][A-Za-z0-9_]*)+", right)
        consequence = "rcl looks for another enclave" if override else "the process ends at start"
        if id(name) in described:
            consequence = "sros2 makes no enclave of it"
        yield finding(
            name,
            f"'{name}' is not a valid enclave name: {consequence}",
            advice=f"write {right}" if valid else "write an absolute name such as /lawn/driver",
            fix=fix(f"write {right}", (name, right)) if valid else None,
        )
