"""Two interfaces get addresses of one subnet.

## What it finds
A static address of a profile in the subnet of another profile of the same folder for another interface, or of an
interface of the only netplan in the tree. Only profiles that name their interface and connect by themselves count.

## Why it matters on a robot
With two interfaces in one subnet the kernel answers for both addresses on either, and packets leave by the first
route: the lidar and the controller are reached only sometimes.

## Bad
```ini
# lidar.nmconnection
address1=192.168.10.1/24
# arm.nmconnection
address1=192.168.10.2/24
```

## Good
```ini
# lidar.nmconnection
address1=192.168.10.1/24
# arm.nmconnection
address1=192.168.11.1/24
```

## When to ignore it
If policy routing separates the two interfaces, or only one of them is ever connected.

## References
- nm-settings(5), "addresses"
- ip-route(8)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.networkmanager import colliding
from bringup_lint.api.networkmanager import colliding_netplan


@rule("error", silent="NetworkManager activates both; the kernel chooses one of the routes without a message")
def address_conflict(robot: Robot) -> Iterator[Finding]:
    for one, other in robot.networkmanager.pairs:
        for first, second in colliding(one, other):
            what = "the same address" if first.ip.ip == second.ip.ip else f"addresses of {second.ip.network}"
            yield finding(
                second.text,
                f"{one.interface} and {other.interface} have {what}: packets can leave by either",
                advice="use separate subnets",
                related=[note(first.text, f"the address of {one.interface}")],
            )
    for profile, address, interface, there in colliding_netplan(robot.networkmanager, robot.netplan.only_plan):
        yield finding(
            address.text,
            f"{profile.interface} and netplan's {interface.name} share {address.ip.network}: packets leave by either",
            advice="use separate subnets",
            related=[note(there.text, f"netplan's address of {interface.name}")],
        )
