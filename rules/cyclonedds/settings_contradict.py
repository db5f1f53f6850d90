"""Cyclone DDS settings contradict each other.

## What it finds
Values that are valid alone but refused together:
- writer watermarks that are out of order (`WhcLow` ≤ `WhcHighInit` ≤ `WhcHigh`)
- a `Transport` that contradicts `TCP/Enable` or `UseIPv6`
- port parameters or a domain number that lead to ports above 65535

## Why it matters on a robot
The library reports `Invalid watermark settings`, `invalid combination of Transport, IPv6, TCP` or `Invalid
port mapping` and creates no participant: no ROS node starts.

## Bad
```xml
<Watermarks>
  <WhcHigh>10kB</WhcHigh>     <!-- below WhcHighInit, which is 30 kB -->
</Watermarks>
```

## Good
```xml
<Watermarks>
  <WhcHigh>10kB</WhcHigh>
  <WhcHighInit>5kB</WhcHighInit>
</Watermarks>
```

## When to ignore it
Never: the library refuses the file, and no node starts.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule(
    "error",
    symptoms=[
        "Invalid watermark settings",
        "invalid combination of Transport, IPv6, TCP",
        "Invalid port mapping",
    ],
)
def settings_contradict(robot: Robot) -> Iterator[Finding]:
    words = {
        Code.WATERMARKS: ("the watermarks are out of order", "keep WhcLow <= WhcHighInit <= WhcHigh"),
        Code.TRANSPORT: (
            "Transport contradicts the older switches",
            "delete TCP/Enable and UseIPv6: Transport replaces both",
        ),
        Code.PORTS: ("the port numbers are not in 1 to 65535", "lower the port parameters or the domain number"),
    }
    for _, remark in robot.dds.remarks(*words):
        what, advice = words[Code(remark.code)]
        yield finding(remark.where, f"{what[0].upper()}{what[1:]} ({remark.detail}): no node starts", advice=advice)
