"""network-online.target without anybody who waits.

## What it finds
In a root file system whose links tell what is enabled: a unit ordered after `network-online.target`, while
no unit is linked into it (`systemd-networkd-wait-online.service`, `NetworkManager-wait-online.service`) and
netplan, which links the waiter itself, is not used.

## Why it matters on a robot
The target is only a meeting point: it is reached when all units ordered before it are done. Without a
waiter there are none, and it is reached at once. `After=` and `Wants=` are both there, and DDS still starts
before the interface has an address.

## Bad
```
/etc/systemd/system/network-online.target.wants/   (empty)
```

## Good
```
/etc/systemd/system/network-online.target.wants/systemd-networkd-wait-online.service
```

## References
- systemd.special(7), "network-online.target"
- <https://github.com/clearpathrobotics/robot_upstart/issues/71>
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

ONLINE = "network-online.target"


@rule("info", symptoms=["does not match an available interface"])
def network_online_no_waiter(robot: Robot):
    units = robot.units
    if not units.knows_enabled or robot.of_kind("netplan") or any(link.unit == ONLINE for link in units.links):
        return
    for unit in units.judged:
        for _, word in unit.naming("After", ONLINE):
            if unit.manager == "system" and any(ONLINE in other.words("Before") for other in units.all) is False:
                yield finding(
                    word,
                    f"Nothing is linked into {ONLINE}, so it is reached at once and {unit.name} does not wait",
                    advice="systemctl enable systemd-networkd-wait-online.service, or the one of NetworkManager",
                )
