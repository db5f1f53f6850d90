"""A sensor of robot_localization has not 15 switches.

## What it finds
`odom0_config`, `imu0_config`, `pose0_config`, `twist0_config` and the like with another number of entries than 15, in
blocks that also name the topic of the sensor.

## Why it matters on a robot
The filter reads 15 switches, three a line: position, orientation, velocity, turn rate, acceleration. It does not look
at the length. With an entry too few it reads what lies after the list, and all entries after the missing one belong to
another quantity: the yaw is never used, or the filter fuses what the sensor does not measure.

## Bad
```yaml
imu0: imu/data
imu0_config: [false, false, false,
              false, false, true,
              false, false, false,
              false, false, true,
              false, false]
```

## Good
```yaml
imu0: imu/data
imu0_config: [false, false, false,
              false, false, true,
              false, false, false,
              false, false, true,
              false, false, false]
```

## When to ignore it
Never.

## References
- robot_localization, ros_filter.cpp (`loadUpdateConfig`) and filter_common.hpp (`STATE_SIZE`)
- https://docs.ros.org/en/noetic/api/robot_localization/html/configuring_robot_localization.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.params import Parameter
from bringup_lint.api.params import ParameterFile

CONFIG = regex(r"(?P<sensor>(?:odom|imu|pose|twist)[0-9]{1,2})_config\Z")
ENTRIES = 15


@rule("error", silent="the filter reads past the end of the list without a word")
def fusion_config_length(robot: Robot) -> Iterator[Finding]:
    found: dict[int, list[tuple[ParameterFile, Parameter, int]]] = {}
    for file, parameter in robot.params.parameters:
        length = of_wrong_length(parameter)
        if length is not None:
            found.setdefault(id(file), []).append((file, parameter, length))
    for (file, first, length), *others in found.values():
        yield finding(
            first.span,
            f"{first.name} has {length} entries, and the filter reads {ENTRIES}: it fuses something else than is meant",
            advice="write five lines of three: position, orientation, velocity, turn rate, acceleration",
            related=[note(each.span, f"{each.name} has {count}") for _, each, count in others],
            severity=None if robot.params.is_used(file) else "info",
        )


def of_wrong_length(parameter: Parameter) -> int | None:
    """How many entries a list of switches has, when that is wrong. rclcpp itself refuses empty and other lists."""
    match, values = CONFIG.match(parameter.name), parameter.value.data
    if match is None or not isinstance(values, list) or len(values) in (0, ENTRIES):
        return None
    if not all(isinstance(each, bool) for each in values):
        return None
    names = {each.name for each in parameter.block.parameters}
    return len(values) if match["sensor"] in names else None
