"""eth0 and wlan0 exist only where predictable names are off.

## What it finds
A physical interface that is matched by its name `eth0` or `wlan0` alone, in a tree that does not switch
predictable names off (`net.ifnames=0`) and shows no Raspberry Pi or Jetson.

## Why it matters on a robot
On a PC with a current distribution the port is called enp3s0 or the like: netplan configures an interface
that never appears, nothing gets an address, and wait-online holds the boot for two minutes.

## Bad
```yaml
eth0: {addresses: [10.0.0.10/24]}
```

## Good
```yaml
lan0:
  match: {macaddress: "00:11:22:33:44:55"}
  set-name: lan0
  addresses: [10.0.0.10/24]
```

## References
- systemd.net-naming-scheme(7)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

BOARD = re.compile(r"net\.ifnames=0|raspberry|raspi|rpi|\bjetson\b|tegra|nvidia-l4t", re.IGNORECASE)


@rule("info", confidence="medium")
def eth0_name(robot: Robot) -> Iterator[Finding]:
    if any(BOARD.search(source.text) or BOARD.search(source.name) for source in robot.sources):
        return
    for interface in robot.netplan.interfaces:
        if interface.is_physical and interface.match is None and interface.name in ("eth0", "wlan0"):
            yield finding(
                interface.name,
                f"{interface.name} exists only where predictable names are off; a PC has names like enp3s0",
                advice="match by MAC address and set a name with set-name",
            )
