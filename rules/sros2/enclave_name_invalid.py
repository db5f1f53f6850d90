"""rcl does not accept the name of an enclave.

## What it finds
A name after `--enclave`, or a path in a policy, that is not absolute or not a valid namespace. A
`ROS_SECURITY_ENCLAVE_OVERRIDE` that does not start with a slash.

## Why it matters on a robot
With `--enclave` the process ends at start, even with security off: `Enclave name is not valid`. rcl does not
check the variable: it cuts off the first character, and does not find the enclave.

## Bad
```sh
ros2 run lawn driver --ros-args --enclave lawn/driver
```

## Good
```sh
ros2 run lawn driver --ros-args --enclave /lawn/driver
```

## When to ignore it
Never: the process ends, or rcl looks for an enclave that does not exist.

## References
- rcl, security.c; tested with the real rcl of Jazzy
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Enclave name is not valid"])
def enclave_name_invalid(robot: Robot) -> Iterator[Finding]:
    overrides = {setting.value.span for setting in robot.ros.of("ROS_SECURITY_ENCLAVE_OVERRIDE")}
    paths = [enclave.path for policy in robot.sros2.policies for enclave in policy.enclaves if enclave.path]
    described = {path.span for path in paths}
    for name in (*robot.sros2.selected, *paths):
        override = name.span in overrides
        if not name or re.fullmatch(r"/|(?:/[A-Za-z_][A-Za-z0-9_]*)+", name) or (override and name.startswith("/")):
            continue
        right = f"/{name.strip('/')}"
        valid = re.fullmatch(r"(?:/[A-Za-z_][A-Za-z0-9_]*)+", right)
        consequence = "rcl looks for another enclave" if override else "the process ends at start"
        if name.span in described:
            consequence = "sros2 cannot create this enclave"
        yield finding(
            name,
            f"'{name}' is not a valid enclave name: {consequence}",
            advice=f"write {right}" if valid else "write an absolute name such as /lawn/driver",
            fix=fix(f"write {right}", (name, right)) if valid else None,
        )
