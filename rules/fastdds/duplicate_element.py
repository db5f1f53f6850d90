"""A Fast DDS element appears twice.

## What it finds
An element that appears twice in a parent that accepts it once.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<useBuiltinTransports>false</useBuiltinTransports>
<useBuiltinTransports>true</useBuiltinTransports>
```

## Good
```xml
<useBuiltinTransports>false</useBuiltinTransports>
```

## When to ignore it
Never: the library ignores the whole file.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import explained

TEXTS: dict[str, tuple[str, str]] = {
    Code.DUPLICATE: (
        "{where} appears twice: the whole file is ignored, the robot runs with defaults",
        "keep one of the two",
    ),
}


@rule("error", symptoms=["Duplicated element found"])
def duplicate_element(robot: Robot) -> Iterator[Finding]:
    yield from explained((remark for _, remark in robot.dds.fastdds_remarks(Code.DUPLICATE)), TEXTS)
