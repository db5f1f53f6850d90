"""A covariance matrix is not symmetric.

## What it finds
Lists of 9, 36 or 225 numbers in parameters whose names end with `covariance` or hold it, in which a number differs from
the one on the other side of the diagonal. Info for those of accelerations, which few filters fuse.

## Why it matters on a robot
A covariance is symmetric by its nature. A number that is only on one side is one that was meant for the diagonal and
slipped by a place: its own variance stays 0, and a filter takes the value for exact.

## Bad
```yaml
static_covariance_linear_acceleration: [0.02, 0.0, 0.0, 0.02, 0.0, 0.0, 0.0, 0.0, 0.02]
```

## Good
```yaml
static_covariance_linear_acceleration: [0.02, 0.0, 0.0, 0.0, 0.02, 0.0, 0.0, 0.0, 0.02]
```

## When to ignore it
Never.

## References
- sensor_msgs/Imu, geometry_msgs/PoseWithCovariance: row major, about the x, y and z axes
- robot_localization, `process_noise_covariance`, `initial_estimate_covariance`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.params import lopsided


@rule("warning", silent="nodes do not look at the symmetry of a covariance")
def covariance_lopsided(robot: Robot) -> Iterator[Finding]:
    for each in lopsided(robot.params):
        zero = f", and the variance of row {each.row + 1} is 0" if each.variance == 0 else ""
        yield finding(
            each.where,
            f"{each.parameter.name} is not symmetric: {each.where.text} is in row {each.row + 1}, column "
            f"{each.column + 1}, and not on the other side of the diagonal{zero}",
            advice=f"write it as number {each.row * (each.size + 1) + 1} of the list"
            if each.variance == 0
            else "write the same number on both sides",
            severity=None if robot.params.is_used(each.file) and "acceleration" not in each.parameter.name else "info",
        )
