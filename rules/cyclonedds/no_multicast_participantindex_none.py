"""Multicast is off, but unicast discovery cannot find random ports.

## What it finds
`AllowMulticast` is `false` and `ParticipantIndex` is `none`, either set or by default. Up to 0.10 the default is
`none`. On Jazzy and Kilted rmw_cyclonedds sets `auto` before it reads the file. From 11 on the library's own default
works. The default does not count if a process reads the file together with others, which may set the index.

## Why it matters on a robot
Unicast discovery looks for other processes at the ports of the indices 0, 1, 2 and so on. With `none` every
process uses random ports: the robot starts without an error, and its nodes do not discover each other.

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
</Discovery>
```

## When to ignore it
If the robot runs a single process and all its peers have a fixed participant index: it contacts them, and
they answer to its random port.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
- rmw_cyclonedds (Jazzy), the configuration that it reads before the user's
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import multicast_off


@rule(
    "error",
    fix="unsafe",
    symptoms=['ManySocketsMode "none" requires SPDP multicast; it is incompatible with multicast discovery disabled'],
)
def no_multicast_participantindex_none(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        off = multicast_off(domain)
        index = domain.get("Discovery/ParticipantIndex")
        if off is None or (index is None and not robot.dds.old_discovery):
            continue
        if index is None and robot.dds.is_part(configuration):
            continue
        if index is not None and (index.effective or "").lower() != "none":
            continue
        where = index.value if index else off.value
        message = "Unicast discovery cannot find random ports: without multicast and with ParticipantIndex none "
        yield finding(
            where,
            message + "the robot starts, but its nodes do not see each other",
            advice="write <ParticipantIndex>auto</ParticipantIndex> in Discovery",
            related=[note(off.value, "multicast is off")] if index else (),
            fix=fix("write auto", (index.value, "auto")) if index else None,
        )
