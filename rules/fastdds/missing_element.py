"""A Fast DDS element has no content or misses a required part.

## What it finds
An element that is empty or does not have a part that the library requires: `durability` without `kind`, a
transport without `type` or `transport_id`, a discovery server without `prefix`.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<durability/>
```

## Good
```xml
<durability>
  <kind>VOLATILE</kind>
</durability>
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
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule(
    "error",
    symptoms=[
        "without content",
        "Not found required attribute",
        "Not found 'type' attribute",
        "couldn't find any",
    ],
)
def missing_element(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.MISSING, Code.EMPTY):
        lacks = f"{remark.where} has no {remark.detail}" if remark.code == Code.MISSING else f"{remark.where} is empty"
        advice = f"add {remark.detail}" if remark.code == Code.MISSING else "give it a value, or delete it"
        yield finding(remark.where, f"{lacks}: the whole file is ignored, the robot runs with defaults", advice=advice)
