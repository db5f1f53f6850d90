"""The control network runs over Wi-Fi.

## What it finds
A VLAN, bridge or bond on top of a Wi-Fi interface, or a Wi-Fi interface itself, whose name contains
`control`, `ctrl`, `motion`, `safety` or `estop`.

## Why it matters on a robot
Retransmissions and roaming can delay velocity commands and stop signals by seconds. A robot must stop when
the Wi-Fi fails.

## Bad
```yaml
vlans:
  control: {id: 10, link: wlan0}
```

## Good
```yaml
vlans:
  control: {id: 10, link: eth0}
```

## When to ignore it
If the name means something else, or the link only carries commands that a watchdog on the robot supervises,
such as teleoperation.

## References
- robotics-security guide: control plane traffic never transits WiFi
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

CONTROL = regex(r"(?:^|[^a-z])(?:control|ctrl|motion|safety|estop|e-stop)(?:$|[^a-z])", re.IGNORECASE)


@rule("warning", confidence="medium", silent="lost packets on Wi-Fi are not reported")
def wifi_control_plane(robot: Robot) -> Iterator[Finding]:
    for plan in robot.netplan.plans:
        wifi = {str(i.name): i for i in plan.interfaces.values() if i.is_wifi}
        for interface in plan.interfaces.values():
            below = [name for name in (interface.link, *interface.members) if name is not None and name in wifi]
            if CONTROL.search(interface.name) and (below or interface.is_wifi):
                related = [note(wifi[str(below[0])].name, "a Wi-Fi interface")] if below else []
                yield finding(
                    interface.name,
                    f"Control traffic over Wi-Fi: {interface.name} " + (f"runs on {below[0]}" if below else "is Wi-Fi"),
                    advice="put the control network on a wired interface",
                    related=related,
                )
