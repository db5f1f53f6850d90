"""An open Wi-Fi network.

## What it finds
An access point without `password` and without `auth`, or with `key-management: none`.

## Why it matters on a robot
Whoever is near can join the network of the robot, read its topics and, without SROS2, drive it.

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


@rule("warning", tags=["CWE-319"])
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
