"""The robot is missing from its own list of peers.

## What it finds
Multicast is off, peers are listed, and the robot is not one of them: not as `localhost`, not by a loopback
address, and not by an address from its netplan.
- **warning**: netplan gives the robot its addresses.
- **info**: the robot's addresses are not known. Only lists of plain addresses are checked then, because a
  host name may be the robot.

Silent if a process reads the file together with others, which may list the robot.

## Why it matters on a robot
A process contacts only its peers. If the list does not include the robot's own computer, its nodes do not
discover each other, although they discover those on other machines.

## Bad
```xml
<AllowMulticast>false</AllowMulticast>
...
<Peer Address="10.0.0.20"/>     <!-- the base station -->
```

## Good
```xml
<Peer Address="localhost"/>
<Peer Address="10.0.0.20"/>
```

## When to ignore it
If only one process on the robot uses this file, for example a bridge to the base station.

## References
- Cyclone DDS, configuration guide, "Discovery addresses"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import contacts_itself
from bringup_lint.api.cyclonedds import multicast_off
from bringup_lint.api.cyclonedds import peer_addresses


@rule(
    "warning",
    fix="unsafe",
    confidence="medium",
    silent="the processes of the computer do not find each other, which is not an error for Cyclone DDS",
)
def peer_self_missing(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        off = multicast_off(domain)
        peers = domain.all("Discovery/Peers/Peer@Address")
        if off is None or not peers or domain.all("Discovery/Peers@AddLocalhost") or contacts_itself(domain):
            continue
        if robot.dds.is_part(configuration):
            continue
        own = robot.dds.own_addresses(configuration)
        if own & {str(address) for address in peer_addresses(domain)}:
            continue
        first = peers[0].owner
        inserted = Span(first.span.source, first.span.start, first.span.start)
        yield finding(
            first.name,
            "Multicast is off and the robot is not among its own peers: its nodes do not see each other",
            advice='add <Peer Address="localhost"/>',
            related=[note(off.value, "multicast is off")],
            chain=robot.provenance.chain_to(first.name, "DDS contacts only these peers"),
            severity=None if own else "info",
            fix=fix("add localhost", (inserted, f'<{first.name} Address="localhost"/>')) if own else None,
        )
