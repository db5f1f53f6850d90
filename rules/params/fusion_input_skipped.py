"""robot_localization never subscribes a sensor, because one before it is missing.

## What it finds
`imu1`, `odom1`, `pose1`, `twist1` and higher in a block with switches (`imu1_config`), when a lower number of the kind
is missing and no launch file and no other file of the node sets it.

## Why it matters on a robot
The filter counts: it asks for `imu0`, then for `imu1`, and stops at the first that is missing. A sensor after a gap is
never subscribed, without a message. The heading then comes from the wheels alone.

## Bad
```yaml
# imu0: camera/imu
imu1: imu/data
imu1_config: [...]
```

## Good
```yaml
imu0: imu/data
imu0_config: [...]
```

## When to ignore it
When a program outside of the tree sets the missing parameter.

## References
- robot_localization, ros_filter.cpp (`load_params`, "more_params")
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import skipped_sensors


@rule("error", silent="the filter stops counting without a word")
def fusion_input_skipped(robot: Robot) -> Iterator[Finding]:
    for each in skipped_sensors(robot.files, robot.params):
        yield finding(
            each.parameter.key.span,
            f"The filter never reads {each.parameter.name}: it stops at {each.missing}, which is missing",
            advice=f"call it {each.missing}, and its other parameters {each.missing}_...",
            related=[note(other.key.span, "is not read, either") for other in each.others],
            severity=None if robot.params.is_used(each.file) else "info",
        )
