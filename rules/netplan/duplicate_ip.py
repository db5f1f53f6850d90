"""Two interfaces of one robot have the same address.

## What it finds
The same static address on two interfaces that netplan configures together. Interfaces in different VRFs are
not reported, and neither is one interface that gets the address from two files.

## Why it matters on a robot
Netplan does not report it. The kernel answers for the address on both networks, and packets leave by the
route that was added last: DDS discovery works after some boots and not after others.

## Bad
```yaml
eth0: {addresses: [10.0.0.10/24]}
eth1: {addresses: [10.0.0.10/24]}
```

## Good
```yaml
eth0: {addresses: [10.0.0.10/24]}
eth1: {addresses: [10.0.1.10/24]}
```

## When to ignore it
If the two interfaces are never up at the same time, such as two variants of a network card.

## References
- netplan YAML reference, "addresses"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.netplan import Address
from bringup_lint.api.netplan import Interface
from bringup_lint.api.netplan import Plan


@rule("error", silent="netplan configures both without a message")
def duplicate_ip(robot: Robot) -> Iterator[Finding]:
    for plan in robot.netplan.plans:
        owners: dict[object, tuple[Interface, Address]] = {}
        for interface in plan.interfaces.values():
            for address in interface.addresses:
                if address.ip is None or address.ip.is_link_local:
                    continue
                other, first = owners.setdefault(address.ip.ip, (interface, address))
                if other is not interface and not apart(plan, other, interface):
                    yield finding(
                        address.text,
                        f"{address.ip.ip} is assigned to {other.name} and {interface.name}",
                        advice="give one of them another address",
                        related=[note(first.text, f"{other.name} has it here")],
                    )


def apart(plan: Plan, one: Interface, other: Interface) -> bool:
    """Whether two interfaces live in routing domains of their own."""
    masters = plan.masters
    domains = [masters.get(str(interface.name)) for interface in (one, other)]
    return domains[0] is not domains[1] and any(domain is not None and domain.kind == "vrfs" for domain in domains)
