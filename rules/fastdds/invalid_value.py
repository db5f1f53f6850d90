"""Fast DDS does not accept a value.

## What it finds
Octets, GUID prefixes and similar values in a form that the library refuses.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<prefix>44.53.00</prefix>
```

## Good
```xml
<prefix>44.53.00.5f.45.50.52.4f.53.49.4d.41</prefix>
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
    Code.VALUE: (
        "'{where}' is not what Fast DDS expects: the whole file is ignored, the robot runs with defaults",
        "write {detail}",
    ),
}


@rule("error", symptoms=["Expected an octet value", "invalid server's guidPrefix"])
def invalid_value(robot: Robot) -> Iterator[Finding]:
    yield from explained((remark for _, remark in robot.dds.fastdds_remarks(Code.VALUE)), TEXTS)
