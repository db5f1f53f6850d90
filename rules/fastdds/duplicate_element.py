"""A Fast DDS element that is given twice.

## What it finds
An element that stands twice in a parent that takes it once.

## Why it matters on a robot
The library ignores the whole file and goes on with its defaults, exit status 0: multicast discovery, no
peers, no limits. Only a line on the terminal tells.

## Bad
```xml
<useBuiltinTransports>false</useBuiltinTransports>
<useBuiltinTransports>true</useBuiltinTransports>
```

## Good
```xml
<useBuiltinTransports>false</useBuiltinTransports>
```

## References
- Fast DDS 2.14.5, tried with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["Duplicated element found"])
def duplicate_element(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.DUPLICATE):
        yield finding(
            remark.where,
            f"{remark.where} is given twice: the whole file is ignored, the robot runs with defaults",
            advice="keep one of the two",
        )
