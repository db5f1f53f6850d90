"""A peer that the robot's network cannot reach.

## What it finds
An address in `initialPeersList` that lies in no subnet of the robot's netplan and that no route covers. Only files of
the same root are joined, and only profiles that a process of the tree reads, where it is known which it does.
Interfaces with DHCP, default routes and other routes make every address reachable, and are left alone.

## Why it matters on a robot
Packets to that machine never leave the robot: it is not discovered, and nothing says why.

## Bad
```xml
<!-- netplan: addresses: [192.168.10.5/24], no routes -->
<initialPeersList>
  <locator><udpv4><address>10.0.0.7</address></udpv4></locator>
</initialPeersList>
```

## Good
```xml
<initialPeersList>
  <locator><udpv4><address>192.168.10.7</address></udpv4></locator>
</initialPeersList>
```

## References
- Fast DDS documentation, "Initial peers"
- netplan YAML reference, "addresses", "routes"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning")
def peer_outside_subnet(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        plan = robot.dds.plan_of(profiles)
        subnets = robot.dds.subnets(plan) if plan else []
        for element in robot.dds.initial_peers(profiles) if subnets else ():
            address = robot.dds.address_of(element.text)
            if address is None or address.is_loopback or address.is_multicast or robot.dds.routed(plan, address):
                continue
            yield finding(
                element.text,
                f"Peer {address} lies in no subnet of this robot and no route covers it: it will not be discovered",
                advice="correct the address, or add a route",
                chain=robot.provenance.chain_to(element.text, f"{address} is to be contacted"),
                related=[note(each.name, f"has {network}") for each, network in subnets[:3]],
            )
