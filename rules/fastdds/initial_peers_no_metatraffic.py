"""Fast DDS peers do not replace multicast.

## What it finds
A default participant with `initialPeersList`, but without `metatrafficUnicastLocatorList` (an empty
`<locator/>` is enough), without `avoid_builtin_multicast` and without a multicast address among the peers.
The finding is information, because you may want peers in addition to multicast.

## Why it matters on a robot
The library only adds the peers: the robot still announces itself by multicast to the whole network.

## Bad
```xml
<initialPeersList>...</initialPeersList>
```

## Good
```xml
<metatrafficUnicastLocatorList>
  <locator/>
</metatrafficUnicastLocatorList>
<initialPeersList>...</initialPeersList>
```

## When to ignore it
If you want both: multicast on the local network, and peers beyond it.

## References
- Fast DDS documentation, "Disabling all Multicast Traffic"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.fastdds import multicast_peers


@rule("info", silent="discovery works, by multicast too")
def initial_peers_no_metatraffic(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        for participant in profiles.default_participants:
            for element in participant.walk():
                peers = element.find("initialPeersList") if element.name == "builtin" else None
                if peers is None or element.find("avoid_builtin_multicast") is not None:
                    continue
                if element.find("metatrafficUnicastLocatorList") is None and not multicast_peers(peers):
                    yield finding(
                        peers.name,
                        "The peers are added to multicast discovery, which stays on",
                        advice="add a metatrafficUnicastLocatorList with an empty <locator/>",
                    )
