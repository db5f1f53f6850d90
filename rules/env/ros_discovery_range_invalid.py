"""ROS_AUTOMATIC_DISCOVERY_RANGE has an invalid value.

## What it finds
A value other than OFF, LOCALHOST, SUBNET and SYSTEM_DEFAULT, in upper case. Only on Iron and newer, which read the
variable.

## Why it matters on a robot
rcl logs one warning and falls back to LOCALHOST: all other machines disappear.

## Bad
```sh
ROS_AUTOMATIC_DISCOVERY_RANGE=subnet
```

## Good
```sh
ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET
```

## When to ignore it
When LOCALHOST is what you want anyway. Writing it costs nothing and removes the warning of rcl too.

## References
- rcl, `discovery_options.c`
- https://github.com/clearpathrobotics/clearpath_config/pull/191
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.ros import DISCOVERY_RANGES
from bringup_lint.api.ros import at_least


@rule("error", fix="unsafe", symptoms=["Invalid value for ROS_AUTOMATIC_DISCOVERY_RANGE"])
def ros_discovery_range_invalid(robot: Robot) -> Iterator[Finding]:
    if not at_least(robot.target.ros, "iron"):
        return
    for setting in robot.ros.of("ROS_AUTOMATIC_DISCOVERY_RANGE"):
        if setting.text in ("", *DISCOVERY_RANGES):
            continue
        upper = setting.text.upper()
        known = upper if upper in DISCOVERY_RANGES else None
        yield finding(
            setting.value,
            f"'{setting.text}' is not a discovery range: the process falls back to LOCALHOST and sees no other machine",
            advice=f"write {known}" if known else "write OFF, LOCALHOST, SUBNET or SYSTEM_DEFAULT",
            fix=fix(f"write {known}", (setting.value, known)) if known else None,
        )
