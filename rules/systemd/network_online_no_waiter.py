"""Nothing waits for the network before network-online.target.

## What it finds
A unit ordered after `network-online.target` in a root file system that shows what is enabled, when no wait
service (`systemd-networkd-wait-online.service`, `NetworkManager-wait-online.service`) is linked into the
target. Trees with netplan, which links the wait service itself, are not checked.

## Why it matters on a robot
The target is only a synchronization point: systemd reaches it when all units ordered before it are done.
Without a wait service there are none, and systemd reaches it at once. `After=` and `Wants=` are both set, and
DDS still starts before the interface has an address.

## Bad
```
/etc/systemd/system/network-online.target.wants/   (empty)
```

## Good
```
/etc/systemd/system/network-online.target.wants/systemd-networkd-wait-online.service
```

## When to ignore it
When something that is not in this tree enables the wait service, for example a preset at the first boot.

## References
- systemd.special(7), "network-online.target"
- <https://github.com/clearpathrobotics/robot_upstart/issues/71>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

ONLINE = "network-online.target"


@rule("info", symptoms=["does not match an available interface"])
def network_online_no_waiter(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    if not units.knows_enabled or robot.of_kind("netplan") or any(link.unit == ONLINE for link in units.links):
        return
    for unit in units.judged:
        for _, word in unit.naming("After", ONLINE):
            if unit.manager == "system" and any(ONLINE in other.words("Before") for other in units.all) is False:
                yield finding(
                    word,
                    f"{ONLINE} has no wait service: systemd reaches it at once, and {unit.name} does not wait",
                    advice="enable systemd-networkd-wait-online.service or NetworkManager-wait-online.service",
                )
