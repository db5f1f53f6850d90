"""An interface has both a static address and DHCP.

## What it finds
`dhcp4: true` and a static IPv4 address on one interface. Link-local addresses are not reported.

## Why it matters on a robot
The interface has two addresses and possibly two default routes. DDS announces both addresses, and peers
choose one. Without a DHCP server, the boot waits for one although the static address would be enough.

## Bad
```yaml
eth0: {dhcp4: true, addresses: [10.0.0.10/24]}
```

## Good
```yaml
eth0: {dhcp4: false, addresses: [10.0.0.10/24]}
```

## When to ignore it
If the static address is for devices on the same cable, such as a LiDAR, and DHCP is for the site network.

## References
- robot-bringup guide, "Static IP Configuration"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", silent="netplan configures both without a message")
def dhcp_and_static(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        flag = interface.flag("dhcp4")
        static = [a for a in interface.addresses if a.ip and a.ip.version == 4 and not a.ip.is_link_local]
        if flag is not None and flag.value and static:
            yield finding(
                flag.where,
                f"{interface.name} has the static address {static[0].text} and DHCP",
                advice="set dhcp4: false, unless you want the second address",
                related=[note(static[0].text, "the static address")],
            )
