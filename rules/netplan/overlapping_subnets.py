"""Two interfaces are in the same subnet.

## What it finds
Two interfaces of one robot with static addresses in overlapping subnets. Members of bridges, bonds and VRFs,
host addresses (/32) and interfaces with their own routing policies are not reported.

## Why it matters on a robot
The kernel has two routes to the same hosts and uses one: devices on the other port are not reached, or
answers leave by the wrong port. With DDS, discovery arrives on one interface and data leaves by the other.

## Bad
```yaml
eth0:  {addresses: [10.0.0.10/24]}
wlan0: {addresses: [10.0.0.11/24]}
```

## Good
```yaml
eth0:  {addresses: [10.0.0.10/24]}
wlan0: {addresses: [10.0.1.11/24]}
```

## When to ignore it
If only one of the interfaces is connected at a time, such as a wired port that replaces the Wi-Fi in the
dock.

## References
- Linux kernel documentation, ip-sysctl, arp_filter
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.netplan import Address
from bringup_lint.api.netplan import Subnets


@rule("warning", silent="netplan configures both; the kernel chooses one of the routes without a message")
def overlapping_subnets(robot: Robot) -> Iterator[Finding]:
    for plan in robot.netplan.plans:
        seen = Subnets()
        for interface in plan.interfaces.values():
            if interface.name in plan.masters or any(True for _ in interface.items("routing-policy")):
                continue
            for address in interface.addresses:
                if address.ip is None or address.ip.is_link_local or address.ip.network.num_addresses < 4:
                    continue
                first = seen.first_overlap(interface, address.ip)
                if first is not None:
                    other = first.interface.name
                    yield finding(
                        address.text,
                        f"{other} and {interface.name} share {address.ip.network}: packets can leave by either",
                        advice="use separate subnets",
                        related=[note(first.address.text, f"{other} is in {first.ip.network}")],
                    )
            for address in interface.addresses:
                if _counts(address):
                    seen.add(interface, address)


def _counts(address: Address) -> bool:
    return address.ip is not None and not address.ip.is_link_local and address.ip.network.num_addresses >= 4
