"""An angle is given in degrees where radians are read.

## What it finds
In parameter files, angles of public nodes that are too large for radians: `magnetic_declination_radians` of
navsat_transform_node beyond a quarter turn, `yaw_offset` beside it beyond a whole one, and thresholds for differences
of headings, which are half a turn at most: `rotate_to_heading_min_angle` and `angular_dist_threshold` of a controller
of Nav2, and `update_min_a` of amcl. Files that nothing names are an info.

## Why it matters on a robot
A declination of 3.7 rad instead of 3.7 degrees turns the whole map by 212 degrees against the field, and the robot
drives off in another direction. A threshold above half a turn is never reached: the robot never turns on the spot, or
does not correct its pose while it turns.

## Bad
```yaml
navsat_transform:
  ros__parameters:
    magnetic_declination_radians: 3.7
```

## Good
```yaml
navsat_transform:
  ros__parameters:
    magnetic_declination_radians: 0.0646
```

## When to ignore it
When a threshold is deliberately so large that it is never reached.

## References
- REP 103: angles are in radians
- robot_localization, navsat_transform.cpp; nav2_regulated_pure_pursuit_controller; nav2_rotation_shim_controller;
  nav2_amcl, amcl_node.cpp
"""

import math
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_NEVER = "no difference of headings gets there"
_TURNED = "the robot takes that for its heading against the map"
_DECLINATION = "magnetic_declination_radians"
_ROUNDED = 0.01
_BESIDE = {"yaw_offset": _DECLINATION, "update_min_a": "odom_frame_id"}
"""What says that an angle is that of the public node; for the others the plugin of their section does."""
_LIMITS = {
    _DECLINATION: (math.pi / 2, _TURNED),
    "yaw_offset": (2 * math.pi + _ROUNDED, _TURNED),
    "rotate_to_heading_min_angle": (math.pi + _ROUNDED, _NEVER),
    "angular_dist_threshold": (math.pi + _ROUNDED, _NEVER),
    "update_min_a": (math.pi + _ROUNDED, _NEVER),
}
"""The largest angle that has a meaning, and what becomes of a larger one."""


@rule("warning", silent="the nodes take any number")
def angle_unit(robot: Robot) -> Iterator[Finding]:
    for file in robot.params.judged:
        for block in file.blocks:
            named = {str(each.name): each for each in block.parameters}
            for name, each in named.items():
                section, _, last = name.rpartition(".")
                value = each.value.data
                largest, effect = _LIMITS.get(last, (math.inf, ""))
                if not isinstance(value, (int, float)) or not largest < abs(value) <= 360:
                    continue
                beside = _BESIDE.get(last, f"{section}.plugin")
                if last == _DECLINATION or beside in named:
                    yield finding(
                        each.span,
                        f"{last} is in radians: {value:g} rad are {math.degrees(value):.0f} degrees, and {effect}",
                        advice=f"write {math.radians(value):.4g} if {value:g} degrees are meant",
                        severity=None if robot.params.is_used(file) else "info",
                    )
