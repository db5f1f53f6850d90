"""A Cyclone DDS interface has neither a name nor an address.

## What it finds
A `NetworkInterface` with neither `name` nor `address`, and without `autodetermine="true"`. A name that comes
from a variable is not checked.

## Why it matters on a robot
The library reports `Nameless and address-less interface listed in interfaces` and creates no participant: no
ROS node starts.

## Bad
```xml
<NetworkInterface multicast="false"/>
```

## Good
```xml
<NetworkInterface name="eth0" multicast="false"/>
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


@rule("error", symptoms=["Nameless and address-less interface"])
def interface_anonymous(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.ANONYMOUS):
        yield finding(
            remark.where,
            "The interface has neither name nor address: no participant can be created, no node starts",
            advice='give it a name, or write autodetermine="true"',
        )
