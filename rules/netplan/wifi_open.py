"""A Wi-Fi network has no encryption.

## What it finds
An access point without `password` and without `auth`, or with `key-management: none`. In files of examples
the finding is only information.

## Why it matters on a robot
Anyone nearby can join the network of the robot, read its topics and, without SROS2, drive it.

## Bad
```yaml
access-points:
  depot: {}
```

## Good
```yaml
access-points:
  depot: {password: "${PSK}"}
```

## When to ignore it
If everything that matters goes through a VPN on top of this network, such as WireGuard, and the firewall
blocks the rest.

## References
- robotics-security guide, network hardening
- CWE-319
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.templates import is_example


@rule("warning", silent="the connection works", tags=["CWE-319"])
def wifi_open(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        for point in interface.access_points:
            if point.is_open and not point.ssid.span.source.template and not point.is_passed_through:
                opens = "opens" if point.mode == "ap" else "joins"
                yield finding(
                    point.ssid,
                    f"{interface.name} {opens} the network '{point.ssid}' without any encryption",
                    advice="add auth or a password",
                    severity="info" if is_example(point.ssid.path) else None,
                )
