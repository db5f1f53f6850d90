"""No multicast and no peers: nothing is discovered.

## What it finds
`AllowMulticast` is `false` (or every interface says `multicast="false"`) and no `Peer` is listed. On
Jazzy and later, `ROS_STATIC_PEERS` and the LOCALHOST discovery range add peers of their own, so there
the finding is a warning.

## Why it matters on a robot
Without multicast a participant only asks the peers that it is told. The robot starts, and no node sees
another one, not even on the same computer.

## Bad
```xml
<General>
  <AllowMulticast>false</AllowMulticast>
</General>
```

## Good
```xml
<General>
  <AllowMulticast>false</AllowMulticast>
</General>
<Discovery>
  <ParticipantIndex>auto</ParticipantIndex>
  <Peers>
    <Peer Address="localhost"/>
  </Peers>
</Discovery>
```

## References
- Cyclone DDS, configuration guide, "Discovery addresses"; rmw_cyclonedds, discovery options (Iron and later)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error")
def no_multicast_no_peers(robot: Robot) -> Iterator[Finding]:
    for _configuration, domain in robot.dds.domains:
        setting = robot.dds.multicast_off(domain)
        if setting is None or robot.dds.has_peers(domain):
            continue
        message = "Without multicast and without peers nothing is discovered, not even on this robot"
        yield finding(
            setting.value,
            message if robot.dds.old_discovery else f"{message}, unless ROS_STATIC_PEERS names them",
            advice='add Discovery/Peers with <Peer Address="localhost"/> and the other hosts',
            severity=None if robot.dds.old_discovery else "warning",
        )
