"""Control, data and management share one network.

## What it finds
A plan with a Wi-Fi interface that joins a network and at least one other interface, without any VLAN, VRF or
tunnel, in which all static addresses are in one subnet.

## Why it matters on a robot
A laptop on the Wi-Fi is in the same network as the motor controllers: every port scan, every stray node and
every burst of images reaches the control traffic.

## Bad
```yaml
eth0:  {addresses: [10.0.0.10/24]}
wlan0: {addresses: [10.0.0.11/24]}
```

## Good
```yaml
vlan10 (control): 10.0.10.10/24 on eth0
vlan20 (data):    10.0.20.10/24 on eth0
wlan0 (management only)
```

## When to ignore it
If the motor controllers are not on Ethernet at all (CAN, EtherCAT, USB), or a managed switch separates the
networks.

## References
- robotics-security guide, network hardening
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", confidence="medium", silent="one network for everything works")
def flat_network(robot: Robot) -> Iterator[Finding]:
    for plan in robot.netplan.plans:
        interfaces = [i for i in plan.interfaces.values() if i.is_configured and i.name not in plan.masters]
        wifi = [i for i in interfaces if i.is_wifi and not any(point.mode == "ap" for point in i.access_points)]
        networks = {a.ip.network for i in interfaces for a in i.addresses if a.ip and not a.ip.is_link_local}
        if not wifi or len(interfaces) < 2 or len(networks) > 1:
            continue
        if any(i.kind in ("vlans", "vrfs", "tunnels") for i in plan.interfaces.values()):
            continue
        yield finding(
            wifi[0].name,
            "Control, data and management share one network: there is no VLAN, and Wi-Fi is part of it",
            advice="separate control, data and management with VLANs",
        )
