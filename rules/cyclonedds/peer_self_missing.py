"""The robot itself is missing from its peers.

## What it finds
Multicast is off, peers are listed, and neither `localhost` nor a loopback address nor an address that
the robot's netplan gives it is among them. Without the robot's addresses only files whose peers are all
plain addresses outside the loopback network are judged, for information.

## Why it matters on a robot
A process contacts only its peers. When the own computer is not one of them, the robot's own nodes do
not see each other, while remote ones do.

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


@rule("warning", fix="safe", confidence="medium")
def peer_self_missing(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        off = robot.dds.multicast_off(domain)
        peers = domain.all("Discovery/Peers/Peer@Address")
        if off is None or not peers or domain.all("Discovery/Peers@AddLocalhost") or robot.dds.contacts_itself(domain):
            continue
        own = robot.dds.own_addresses(configuration)
        if own & {str(address) for address in robot.dds.peer_addresses(domain)}:
            continue
        first = peers[0].owner
        inserted = Span(first.span.source, first.span.start, first.span.start)
        yield finding(
            first.name,
            "The robot itself is not among its peers, and multicast is off: its own nodes do not see each other",
            advice='add <Peer Address="localhost"/>',
            related=[note(off.value, "multicast is off")],
            chain=robot.provenance.chain_to(first.name, "only these peers are contacted"),
            severity=None if own else "info",
            fix=fix("add localhost", (inserted, f'<{first.name} Address="localhost"/>')) if own else None,
        )
