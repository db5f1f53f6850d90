"""The renderer does not support a setting.

## What it finds
Settings that the renderer of an interface rejects:
- **networkd**: an access point (`mode: ap`), Wi-Fi with `match:`, modems, and DHCP overrides that differ
  between IPv4 and IPv6
- **NetworkManager**: a match by driver, options of addresses, `ipv6-mtu`, `activation-mode: off`, and routes
  that are not unicast

## Why it matters on a robot
Netplan stops while it writes: the files of some interfaces are new, those of others are old or missing. A
robot that should create its own hotspot comes up without Wi-Fi.

## Bad
```yaml
wifis:
  wlan0:
    access-points:
      robot-7: {mode: ap, password: "${PSK}"}
```

## Good
```yaml
wifis:
  renderer: NetworkManager
  wlan0:
    access-points:
      robot-7: {mode: ap, password: "${PSK}"}
```

## When to ignore it
Never: netplan stops before it has written all files.

## References
- netplan YAML reference, "Properties for device type wifis:"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode
from bringup_lint.api.schema import explained

MESSAGE = "netplan stops halfway: {detail}"
TEXTS: dict[str, tuple[str, str]] = {
    PlanCode.NETWORKD_LACKS: (MESSAGE, "choose renderer: NetworkManager, or remove this setting"),
    PlanCode.NETWORK_MANAGER_LACKS: (MESSAGE, "choose renderer: networkd, or remove this setting"),
    PlanCode.DIFFERENT_OVERRIDES: (MESSAGE, "write the same value in both"),
}


@rule("error", symptoms=["networkd does not support this wifi mode", "networkd backend does not support"])
def renderer_unsupported(robot: Robot) -> Iterator[Finding]:
    yield from explained(robot.netplan.problems(*TEXTS), TEXTS)
