"""Multicast is off and there are no peers, so nothing is discovered.

## What it finds
`AllowMulticast` is `false`, and no `Peer` is listed. On Iron and later the finding is a warning, because
`ROS_STATIC_PEERS` and the LOCALHOST discovery range add peers.

Not reported where the library adds the computer's own address: on the loopback interface and with `multicast="false"`
at the interface (up to 0.10), and from 11 on unless `AddLocalhost` is `false`. Silent, too, if a process reads the file
together with others: one of them may list the peers.

## Why it matters on a robot
Without multicast, a participant contacts only the peers that are listed. The robot starts, and no node
discovers another one, not even on the same computer.

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

## When to ignore it
If the peers come from `ROS_STATIC_PEERS`, or from a file that only the robot's own `CYCLONEDDS_URI` adds.

## References
- Cyclone DDS 0.10.5, q_init.c; 11.0.1, ddsi_init.c, tested with the real library
- Cyclone DDS, configuration guide, "Discovery addresses"; rmw_cyclonedds, discovery options (Iron and later)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import finds_itself
from bringup_lint.api.cyclonedds import has_peers
from bringup_lint.api.cyclonedds import multicast_off


@rule("error", silent="a participant that finds nobody is not an error for Cyclone DDS")
def no_multicast_no_peers(robot: Robot) -> Iterator[Finding]:
    if robot.target.ros and not robot.dds.cyclonedds.known:
        return
    for configuration, domain in robot.dds.domains:
        setting = multicast_off(domain)
        if setting is None or has_peers(domain) or finds_itself(domain, configuration.version):
            continue
        if robot.dds.is_part(configuration):
            continue
        message = "Without multicast and without peers nothing is discovered, not even on this robot"
        yield finding(
            setting.value,
            message if robot.dds.old_discovery else f"{message}, unless ROS_STATIC_PEERS names them",
            advice='add Discovery/Peers with <Peer Address="localhost"/> and the other hosts',
            severity=None if robot.dds.old_discovery else "warning",
        )
