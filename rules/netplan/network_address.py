"""An interface has the network address or the broadcast address.

## What it finds
A static address whose host part is all zeros, or, for IPv4, all ones. Prefixes /31 and /32 (/127 and /128) do
not have such addresses.

## Why it matters on a robot
The kernel accepts the address, but other hosts do not answer to it, or treat packets to it as a broadcast:
the robot is up and unreachable.

## Bad
```yaml
addresses: [10.0.0.0/24]
```

## Good
```yaml
addresses: [10.0.0.10/24]
```

## When to ignore it
For IPv6, if the router of this link does not use the subnet-router anycast address. For IPv4 never.

## References
- RFC 1122, section 3.2.1.3
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", silent="netplan accepts the address without a message")
def network_address(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        for address in interface.addresses:
            ip = address.ip
            if ip is None or ip.network.prefixlen >= ip.max_prefixlen - 1:
                continue
            if ip.ip == ip.network.network_address:
                what = "the network address, not a host address"
            elif ip.version == 4 and ip.ip == ip.network.broadcast_address:
                what = "the broadcast address, not a host address"
            else:
                continue
            yield finding(address.text, f"{address.text} is {what}", advice="choose an address inside the subnet")
