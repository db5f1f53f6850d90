"""DDS peers have fixed addresses, but the robot gets its own from DHCP.

## What it finds
A robot whose netplan has no static address, while its Cyclone DDS file lists peers by address.

## Why it matters on a robot
The other machines list this robot by its address too. After the lease changes, they contact an address that
nobody has. With multicast off, nothing else finds the robot.

## Bad
```
eth0: {dhcp4: true}                <Peer address="10.0.0.20"/>
```

## Good
```
eth0: {addresses: [10.0.0.10/24]}  <Peer address="10.0.0.20"/>
```

## When to ignore it
If the DHCP server has a fixed lease for the robot, or the other machines list it by host name.

## References
- robot-bringup guide, checklist
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.addresses import is_address


@rule("info", silent="the robot gets an address, only not the one that the others expect")
def no_static_ip(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        plan = robot.dds.plan_of(configuration)
        peers = domain.all("Discovery/Peers/Peer@Address")
        fixed = [peer for peer in peers if peer.effective and is_address(peer.effective)]
        if plan is None or not fixed or any(i.addresses for i in plan.interfaces.values()):
            continue
        wired = [i for i in plan.interfaces.values() if i.kind == "ethernets" and i.dhcp4]
        flag = wired[0].flag("dhcp4") if wired else None
        if flag is not None:
            yield finding(
                flag.where,
                f"DDS peers have fixed addresses, but {wired[0].name} gets its own from DHCP",
                advice="give it a static address, or a fixed lease in the DHCP server",
                related=[note(fixed[0].value, "a peer with a fixed address")],
            )
