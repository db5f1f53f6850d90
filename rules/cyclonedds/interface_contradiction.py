"""A Cyclone DDS interface is both autodetermined and named, or appears twice.

## What it finds
A `NetworkInterface` with `autodetermine="true"` and a name or address, or an interface that is named twice.

## Why it matters on a robot
The library refuses the file and creates no participant: no ROS node starts.

## Bad
```xml
<NetworkInterface name="eth0" autodetermine="true"/>
```

## Good
```xml
<NetworkInterface name="eth0"/>
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
        "An autodetermined interface should not have its name or address property specified",
        "may not be selected twice",
    ],
)
def interface_contradiction(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.INTERFACE_TWICE):
        yield finding(
            remark.where,
            f"Interface {remark.detail} is selected twice: no participant can be created, no node starts",
            advice="keep one of the two",
        )
    for _, remark in robot.dds.remarks(Code.AUTODETERMINED):
        yield finding(
            remark.where,
            f"An interface with autodetermine must not have the {remark.known.name} '{remark.where}': no node starts",
            advice=f"delete autodetermine, or the {remark.known.name}",
        )
