"""The only Wi-Fi profile of the robot does not connect by itself.

## What it finds
`autoconnect=false` in the only Wi-Fi profile of a folder of profiles, where no other profile connects by itself.
Without the key, NetworkManager connects by itself: the default is true. Profiles of access points, ad-hoc and mesh
networks are left out. Silent if a file of the tree runs `nmcli ... up`.

## Why it matters on a robot
After a restart, or when the robot leaves the range of the access point and comes back, nobody runs `nmcli connection
up`: the robot stays without network.

## Bad
```ini
[connection]
id=depot
type=wifi
autoconnect=false
```

## Good
```ini
[connection]
id=depot
type=wifi
```

## When to ignore it
If a script or a unit outside of the tree brings the profile up.

## References
- nm-settings(5), "autoconnect"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.networkmanager import alone_off

BROUGHT_UP = regex(r"\bnmcli\b[^\n]{0,200}\bup\b")


@rule("warning", silent="NetworkManager waits for somebody to activate the profile")
def autoconnect_off(robot: Robot) -> Iterator[Finding]:
    for folder in robot.networkmanager.folders:
        where = alone_off(folder)
        if where is not None and where.span.source.judged and not robot.mentions(BROUGHT_UP):
            yield finding(
                where,
                "The robot's only Wi-Fi profile does not connect by itself: after a restart there is no network",
                advice="remove the line, or write autoconnect=true",
            )
