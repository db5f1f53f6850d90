"""Old and new Cyclone DDS interface settings together.

## What it finds
`NetworkInterfaceAddress`, `PreferMulticast` or `AssumeMulticastCapable` beside an `Interfaces` group
with an interface. Their idle values (`auto`, `false`) are fine. `AssumeMulticastCapable` alone is found
too: from 0.9 on it always makes the start fail.

## Why it matters on a robot
The library says `do not pass deprecated configuration` and creates no participant: no ROS node starts.
For `AssumeMulticastCapable` alone it fails without saying anything.

## Bad
```xml
<Interfaces>
  <NetworkInterface name="eth0"/>
</Interfaces>
<NetworkInterfaceAddress>eth0</NetworkInterfaceAddress>
```

## Good
```xml
<Interfaces>
  <NetworkInterface name="eth0"/>
</Interfaces>
```

## References
- Cyclone DDS 0.10.5 and 11.0.1, tried with the real library
- https://github.com/eclipse-cyclonedds/cyclonedds/issues/1528
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["do not pass deprecated configuration"])
def mixed_interface_config(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.MIXED_INTERFACES):
        if remark.detail:
            message = (
                f"{remark.where} together with Interfaces is fatal ('do not pass deprecated "
                "configuration'): no node starts"
            )
            advice = f"delete {remark.where} and say it in the NetworkInterface"
        else:
            message = f"{remark.where} makes the start fail without a word from 0.9 on: no node starts"
            advice = 'write <NetworkInterface name="..." multicast="true"/> inside General/Interfaces'
        yield finding(remark.where, message, advice=advice)
