"""A Cyclone DDS peer is not an address.

## What it finds
A peer with a network prefix (`10.0.0.0/24`), a number above 255, or a port that is not in 1 to 65535. One
`Peer` may list several addresses separated by commas, and host names are valid.

## Why it matters on a robot
Up to 0.10 the library drops the peer with a log line and does not discover that machine. From 11 on the
process aborts: no ROS node starts.

## Bad
```xml
<Peer Address="10.0.0.0/24"/>
```

## Good
```xml
<Peer Address="10.0.0.10"/>
<Peer Address="10.0.0.11"/>
```

## When to ignore it
Never: no version of the library contacts such a peer.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import bad_addresses


@rule("error", symptoms=["add_peer_address", "unknown address", "not a valid address"])
def peer_invalid(robot: Robot) -> Iterator[Finding]:
    aborts = robot.dds.cyclonedds.version == "11"
    for _configuration, domain in robot.dds.domains:
        for peer in domain.all("Discovery/Peers/Peer@Address"):
            for part, why in bad_addresses(peer):
                effect = "every process aborts" if aborts else "the peer is dropped, its nodes are not discovered"
                yield finding(
                    part,
                    f"Peer '{part}' {why}: {effect}",
                    advice="write one address or host name, such as 10.0.0.10 or 10.0.0.10:7412",
                )
