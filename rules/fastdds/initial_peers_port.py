"""A Fast DDS peer without a port reaches only the first participants of a host.

## What it finds
A default participant that more than four processes of the robot use, and for which all of the following is
true:
- Its `initialPeersList` has this machine (127.0.0.1 or localhost) without a port.
- It switches multicast discovery off.
- Nothing in the file sets `maxInitialPeersRange`.

## Why it matters on a robot
A peer without a port covers only the participants 0 to 3 of that host: nodes that start later do not discover
each other.

## Bad
```xml
<initialPeersList><locator><udpv4><address>127.0.0.1</address></udpv4></locator></initialPeersList>
```

## Good
```xml
<transport_descriptor>
  <transport_id>lan</transport_id><type>UDPv4</type><maxInitialPeersRange>30</maxInitialPeersRange>
</transport_descriptor>
```

## When to ignore it
If no more than four of the processes run at the same time.

## References
- Fast DDS documentation, "Initial peers"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.addresses import is_loopback
from bringup_lint.api.xml import Element

RANGE = 4


@rule("info", confidence="medium", silent="participants that are not reached are not reported")
def initial_peers_port(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        if "maxInitialPeersRange" in profiles.source.said:
            continue
        readers = robot.dds.profile_readers(profiles)
        count = sum(robot.ros.started_by(process) for process, _ in readers)
        if count <= RANGE:
            continue
        for participant in profiles.default_participants:
            for peers in participant.walk():
                quiet = peers.parent is not None and peers.parent.find("metatrafficUnicastLocatorList") is not None
                here = [address for address in _without_port(peers) if is_loopback(address)]
                if peers.local == "initialPeersList" and quiet and here:
                    yield finding(
                        here[0],
                        f"A peer without a port covers {RANGE} participants, but {count} processes use the profile",
                        advice=f"set maxInitialPeersRange to {count + 10} in a UDPv4 transport, and use that transport",
                        related=[note(process.where, "reads the profile") for process, _ in readers[:3]],
                    )


def _without_port(peers: Element) -> Iterator[Located]:
    for locator in peers.walk():
        address = locator.find("address")
        if address is not None and locator.find("port") is None:
            yield address.text
