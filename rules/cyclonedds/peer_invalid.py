"""A Cyclone DDS peer that is no address.

## What it finds
A peer with a network prefix (`10.0.0.0/24`), a number above 255, or a port that is not 1 to 65535. One
`Peer` may list several addresses with commas, and host names are fine.

## Why it matters on a robot
Up to 0.10 the peer is dropped with a log line and that machine is not discovered. From 11 on the
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

## References
- Cyclone DDS 0.10.5 and 11.0.1, tried with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["add_peer_address", "unknown address", "not a valid address"])
def peer_invalid(robot: Robot) -> Iterator[Finding]:
    aborts = robot.dds.cyclonedds.version == "11"
    for _configuration, domain in robot.dds.domains:
        for peer in domain.all("Discovery/Peers/Peer@Address"):
            for part, why in robot.dds.bad_addresses(peer):
                effect = "every process aborts" if aborts else "the peer is dropped, its nodes are not discovered"
                yield finding(
                    part,
                    f"Peer '{part}' {why}: {effect}",
                    advice="write one address or host name, as 10.0.0.10 or 10.0.0.10:7412",
                )
