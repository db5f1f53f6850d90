"""A Fast DDS duration as plain text.

## What it finds
A duration element with text other than `DURATION_INFINITY`. Durations take `sec` and `nanosec`
elements.

## Why it matters on a robot
The library ignores the whole file and goes on with its defaults, exit status 0: multicast discovery, no
peers, no limits. Only a line on the terminal tells.

## Bad
```xml
<leaseDuration>10</leaseDuration>
```

## Good
```xml
<leaseDuration>
  <sec>10</sec>
</leaseDuration>
```

## References
- Fast DDS 2.14.5, tried with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="safe", symptoms=["elements cannot be empty"])
def lease_duration_text(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.DURATION):
        text = remark.where
        change = fix("write sec", (text, f"<sec>{text}</sec>")) if text.isdigit() else None
        yield finding(
            text,
            f"{remark.detail} needs sec and nanosec elements: the whole file is ignored, the robot runs with defaults",
            advice=f"write <sec>{text}</sec>" if change else "write <sec>...</sec><nanosec>...</nanosec>",
            fix=change,
        )
