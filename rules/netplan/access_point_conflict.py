"""The same Wi-Fi interface is a client in netplan and the access point of hostapd.

## What it finds
A Wi-Fi interface that netplan connects to a network, and that `interface=` of a hostapd.conf of the same robot names as
well. An access point that netplan itself opens (`mode: ap`) is not meant. Silent where a script installs the package of
hostapd and nothing unmasks its service, which then never starts.

## Why it matters on a robot
netplan starts wpa_supplicant for the interface, hostapd wants it for itself. Who comes last takes the interface away
from the other: the access point is not there, or disappears after a reboot, and with it the only way to the robot.

## Bad
```yaml
# hostapd.conf: interface=wlan0
wifis:
  wlan0:
    dhcp4: true
    access-points:
      yard: {password: ...}
```

## Good
```yaml
# hostapd.conf: interface=wlan0
wifis:
  wlan1:
    dhcp4: true
    access-points:
      yard: {password: ...}
```

## When to ignore it
When a script enables only one of the two.

## References
- hostapd.conf(5); netplan(5), "wifis"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

INSTALLED = regex(r"^[^#\n]{0,200}\bapt(?:-get)?\b[^\n]{0,200}\binstall\b[^\n]{0,300}\bhostapd\b", re.M)
"""The package masks its service when it is installed."""
UNMASKED = regex(r"^[^#\n]{0,200}\bunmask\b[^\n]{0,200}\bhostapd\b|\bmasked:[ \t]*(?:no|false)\b", re.M)
INTERFACE = regex(r"^[ \t]*interface=(?P<name>[\w.-]{1,15})[ \t\r]*$", re.M)


@rule("warning", symptoms=["nl80211: Could not configure driver mode", "AP-DISABLED"])
def access_point_conflict(robot: Robot) -> Iterator[Finding]:
    taken = list(_of_hostapd(robot))
    if not taken or (robot.mentions(INSTALLED) and not robot.mentions(UNMASKED)):
        return
    for interface in robot.netplan.interfaces:
        joined = [point for point in interface.access_points if point.mode != "ap"]
        for name in taken:
            if joined and interface.device == name and robot.same_robot(name, joined[0].ssid):
                yield finding(
                    joined[0].ssid,
                    f"netplan connects {name} to a network, and hostapd opens an access point on it: they take it away "
                    "from each other",
                    advice="use a second interface, or let netplan open the access point with mode: ap",
                    related=[note(name, "hostapd takes it here")],
                    confidence="medium",
                )


def _of_hostapd(robot: Robot) -> Iterator[Located]:
    for source in robot.files.of_kind("hostapd"):
        if source.judged and not source.template:
            yield from (source.located(*match.span("name")) for match in INTERFACE.finditer(source.text))
