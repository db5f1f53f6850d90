"""Old and new Cyclone DDS interface settings are mixed.

## What it finds
`NetworkInterfaceAddress`, `PreferMulticast` or `AssumeMulticastCapable` together with an `Interfaces` group
that has an interface. Values that do nothing (`auto`, `false`) are not reported. `AssumeMulticastCapable` is
also reported alone, because from 0.9 on it always makes the start fail.

## Why it matters on a robot
The library reports `do not pass deprecated configuration` and creates no participant: no ROS node starts. For
`AssumeMulticastCapable` alone it fails without a message.

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

## When to ignore it
Never: the library refuses the file, and no node starts.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
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
            advice = f"delete {remark.where}, and set it in the NetworkInterface"
        else:
            message = f"From 0.9 on, {remark.where} makes the start fail without a message: no node starts"
            advice = 'write <NetworkInterface name="..." multicast="true"/> inside General/Interfaces'
        yield finding(remark.where, message, advice=advice)
