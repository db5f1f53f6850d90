"""'priority' in limits.conf sets the nice value, not the real-time priority.

## What it finds
A `priority` line with a positive value. It sets the nice value. `rtprio` limits the real-time priority.
One finding for each file, which is info where a compose file mounts it into a container.

## Why it matters on a robot
`@realtime - priority 99` gives every process of the group the lowest priority: the control loop runs after
everything else.

## Bad
```
@realtime - priority 99
```

## Good
```
@realtime - rtprio 99
```

## When to ignore it
When the group is meant to run with a lower priority, such as users of a batch job.

## References
- limits.conf(5)
- https://github.com/ros-controls/ros2_control/issues/3605
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

LINE = regex(r"^[ \t]*[^#\s]\S*[ \t]+(?:-|soft|hard)[ \t]+(priority)[ \t]+(\d+)", re.M)


@rule("warning", silent="pam_limits sets the nice value as it is told")
def limits_conf_priority(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("limits-conf"):
        found = [match for match in LINE.finditer(source.text) if int(match[2][:6]) > 0]
        if not found:
            continue
        first, *others = found
        yield finding(
            source.located(*first.span(1)),
            f"'priority {first[2]}' is a nice value: it makes all processes of the group slower",
            advice=f"write rtprio {first[2]}",
            related=[note(source.located(*other.span(1)), "a nice value, too") for other in others],
            severity="info" if is_mounted(robot, source) else None,
        )


def is_mounted(robot: Robot, source: Source) -> bool:
    """Whether a container gets the file, in which hardly anybody logs in."""
    places = (volume for service in robot.compose.services for volume in service.volumes)
    return any(
        str(each.source).rpartition("/")[2] == source.basename and str(each.target).startswith("/etc/security/")
        for each in places
    )
