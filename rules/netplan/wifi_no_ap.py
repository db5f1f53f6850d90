"""A Wi-Fi interface has no access points.

## What it finds
An entry below `wifis:` that has no `access-points` after the same file and all earlier ones are merged.

## Why it matters on a robot
Netplan stops: no interface is configured, not even the wired ones.

## Bad
```yaml
wifis:
  wlan0: {dhcp4: true}
```

## Good
```yaml
wifis:
  wlan0:
    dhcp4: true
    access-points: {depot: {password: "${PSK}"}}
```

## When to ignore it
Only if the access points are in a file that is not in the tree and that netplan reads earlier.

## References
- netplan YAML reference, "access-points"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode
from bringup_lint.api.schema import explained

TEXTS: dict[str, tuple[str, str]] = {
    PlanCode.NO_ACCESS_POINT: ("{where} has no access points: netplan generates nothing", "add access-points"),
}


@rule("error", symptoms=["No access points defined"])
def wifi_no_ap(robot: Robot) -> Iterator[Finding]:
    yield from explained(robot.netplan.problems(*TEXTS), TEXTS)
