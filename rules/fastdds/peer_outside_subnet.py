"""The robot's network cannot reach a peer.

## What it finds
An address in `initialPeersList` that is in no subnet of the robot's netplan and that no route covers. Files
are compared only below the same root, and only for profiles that a process of the tree is known to read.
Nothing is reported if an interface uses DHCP or a default route exists, because then every address may be
reachable.

## Why it matters on a robot
Packets to that machine never leave the robot: it is not discovered, and no message says why.

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

## When to ignore it
If the address is reached through an interface that netplan does not configure, such as a VPN whose files are not in
the tree.

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
from bringup_lint.api.addresses import address_of
from bringup_lint.api.dds import subnets
from bringup_lint.api.fastdds import initial_peers


@rule("warning", silent="a peer that does not answer is not an error for Fast DDS")
def peer_outside_subnet(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        plan = robot.dds.plan_of(profiles)
        known = subnets(plan) if plan is not None else []
        if plan is None or not known:
            continue
        for element in initial_peers(profiles):
            address = address_of(element.text)
            if address is None or address.is_loopback or address.is_multicast or robot.dds.may_reach(plan, address):
                continue
            yield finding(
                element.text,
                f"Peer {address} is in no subnet of this robot and no route covers it: it is not discovered",
                advice="correct the address, or add a route",
                chain=robot.provenance.chain_to(element.text, f"DDS contacts {address}"),
                related=[note(each.name, f"has {network}") for each, network in known[:3]],
            )
