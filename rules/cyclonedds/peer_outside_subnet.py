"""A peer that the robot's network cannot reach.

## What it finds
A peer address that lies in no subnet of the robot's netplan and that no route covers. Interfaces with
DHCP, default routes and other routes make every address reachable, and are left alone.

## Why it matters on a robot
Packets to that machine never leave the robot: it is not discovered, and nothing says why.

## Bad
```xml
# netplan: eth0 has 10.0.0.10/24, no route
<Peer Address="10.10.0.2"/>
```

## Good
```xml
<Peer Address="10.0.0.2"/>
```

## References
- netplan YAML reference, "routes"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning")
def peer_outside_subnet(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        plan = robot.dds.plan_of(configuration)
        for peer in robot.dds.peers(domain) if plan and plan.interfaces else ():
            address = robot.dds.address_of(peer)
            if address is None or address.is_loopback or address.is_multicast or robot.dds.routed(plan, address):
                continue
            subnets = [(each, network) for each in plan.interfaces.values() for network in robot.dds.networks(each)]
            if subnets:
                yield finding(
                    peer,
                    f"Peer {address} lies in no subnet of this robot and no route covers it: it will not be discovered",
                    advice="correct the address, or add a route",
                    chain=robot.provenance.chain_to(peer, f"{peer} is to be contacted"),
                    related=[note(each.name, f"has {network}") for each, network in subnets[:3]],
                )
