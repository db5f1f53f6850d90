"""The robot's network cannot reach a peer.

## What it finds
A peer address that is in no subnet of the robot's netplan and that no route covers. Nothing is reported if an
interface uses DHCP or a default route exists, because then every address may be reachable.

## Why it matters on a robot
Packets to that machine never leave the robot: it is not discovered, and no message says why.

## Bad
```xml
# netplan: eth0 has 10.0.0.10/24, no route
<Peer Address="10.10.0.2"/>
```

## Good
```xml
<Peer Address="10.0.0.2"/>
```

## When to ignore it
If the address is reached through an interface that netplan does not configure, such as a VPN whose files are not in
the tree.

## References
- netplan YAML reference, "routes"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.addresses import address_of
from bringup_lint.api.cyclonedds import peers
from bringup_lint.api.dds import networks


@rule("warning", symptoms=["ddsi_udp_conn_write to * failed with retcode"])
def peer_outside_subnet(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        plan = robot.dds.plan_of(configuration)
        if plan is None or not plan.interfaces:
            continue
        for peer in peers(domain):
            address = address_of(peer)
            if address is None or address.is_loopback or address.is_multicast or robot.dds.may_reach(plan, address):
                continue
            subnets = [(each, network) for each in plan.interfaces.values() for network in networks(each)]
            if subnets:
                yield finding(
                    peer,
                    f"Peer {address} is in no subnet of this robot and no route covers it: it is not discovered",
                    advice="correct the address, or add a route",
                    chain=robot.provenance.chain_to(peer, f"DDS contacts {peer}"),
                    related=[note(each.name, f"has {network}") for each, network in subnets[:3]],
                )
