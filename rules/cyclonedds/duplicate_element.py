"""A Cyclone DDS setting appears twice.

## What it finds
One setting with two values in the same Domain block, also if its group is opened twice. Peers, interfaces and
threads may appear several times. A second Domain block or file overrides the first one and is not reported.

## Why it matters on a robot
The library reports `only 1 instance allowed` and creates no participant: no ROS node starts.

## Bad
```xml
<AllowMulticast>false</AllowMulticast>
<AllowMulticast>spdp</AllowMulticast>
```

## Good
```xml
<AllowMulticast>spdp</AllowMulticast>
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
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import first_named
from bringup_lint.api.schema import Code


@rule("error", symptoms=["only 1 instance allowed"])
def duplicate_element(robot: Robot) -> Iterator[Finding]:
    for configuration, remark in robot.dds.remarks(Code.DUPLICATE):
        first = first_named(configuration, remark)
        yield finding(
            remark.where,
            f"{remark.detail} appears twice (only 1 instance allowed): no participant can be created, no node starts",
            advice="keep one of the two",
            related=[note(first, "the first one")] if first else (),
        )
