"""A Fast DDS duration is plain text.

## What it finds
A duration element with text other than `DURATION_INFINITY`. A duration is written with the elements `sec` and
`nanosec`.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

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

## When to ignore it
Never: the library ignores the whole file.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["elements cannot be empty"])
def lease_duration_text(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.DURATION):
        text = remark.word
        change = fix("write sec", (text, f"<sec>{text}</sec>")) if text.isdecimal() else None
        yield finding(
            text,
            f"{remark.detail} needs sec and nanosec elements: the whole file is ignored, the robot runs with defaults",
            advice=f"write <sec>{text}</sec>" if change else "write <sec>...</sec><nanosec>...</nanosec>",
            fix=change,
        )
