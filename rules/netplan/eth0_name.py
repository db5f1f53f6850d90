"""eth0 and wlan0 exist only if predictable names are off.

## What it finds
A physical interface that is called `eth0` or `wlan0` and has no `match`, in a tree that neither switches
predictable names off (`net.ifnames=0`) nor mentions a Raspberry Pi or Jetson.

## Why it matters on a robot
On a PC with a current distribution the port has a name such as enp3s0. Netplan configures an interface that
never appears, no interface gets an address, and wait-online delays the boot for two minutes.

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

## When to ignore it
If the robot's computer really has this name, as `ip link` shows: many ARM boards and virtual machines do.

## References
- systemd.net-naming-scheme(7)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

BOARD = regex(r"net\.ifnames=0|raspberry|raspi|rpi|\bjetson\b|tegra|nvidia-l4t", re.IGNORECASE)


@rule("info", confidence="medium", symptoms=["Cannot find device eth", 'Device "eth0" does not exist'])
def eth0_name(robot: Robot) -> Iterator[Finding]:
    named = [each for each in robot.netplan.interfaces if each.is_physical and each.name in ("eth0", "wlan0")]
    if not named or any(_is_of_board(source) for source in robot.sources):
        return
    for interface in named:
        if interface.match is None:
            yield finding(
                interface.name,
                f"{interface.name} exists only if predictable names are off; a PC has names such as enp3s0",
                advice="match by MAC address and set the name with set-name",
            )


def _is_of_board(source: Source) -> bool:
    """Whether a file is for a computer whose interfaces have such names."""
    named = source.once(_is_of_board, lambda: BOARD.search(source.said) is not None)
    return named or BOARD.search(source.name) is not None
