"""DDS is bound to an address that the robot's netplan does not assign.

## What it finds
An address by which a Cyclone DDS file selects the interface (`NetworkInterface address=` or
`NetworkInterfaceAddress`), and which no interface of the same robot's netplan has. Nothing is reported if an
interface uses DHCP, or if the tree has several plans. For names of interfaces, see
`cyclonedds/interface-not-in-netplan`.

## Why it matters on a robot
The library finds no interface with this address: `does not match an available interface`, and no node starts.
This happens when a file is copied from one robot to the next.

## Bad
```
<NetworkInterface address="10.0.0.10"/>     netplan: addresses: [10.0.0.11/24]
```

## Good
```
<NetworkInterface address="10.0.0.11"/>     netplan: addresses: [10.0.0.11/24]
```

## When to ignore it
If something other than netplan assigns the address on the robot, such as a VPN client or a script.

## References
- robot-bringup guide, DDS section and checklist
- Cyclone DDS configuration guide, "General/Interfaces/NetworkInterface"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.addresses import is_address
from bringup_lint.api.addresses import is_loopback


@rule("warning", symptoms=["does not match an available interface"])
def peer_ip_mismatch(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        plan = robot.dds.plan_of(configuration)
        own = robot.dds.own_addresses(configuration)
        if plan is None or not own:
            continue
        chosen = [domain.of(element, "address") for element in domain.found("General/Interfaces/NetworkInterface")]
        for setting in (*chosen, domain.get("General/NetworkInterfaceAddress")):
            address = setting.effective if setting is not None else None
            if setting is None or not address or not is_address(address) or address in own or is_loopback(address):
                continue
            static = [a.text for interface in plan.interfaces.values() for a in interface.addresses]
            yield finding(
                setting.value,
                f"DDS is bound to {address}, which this robot does not have: no node starts",
                advice=f"write one of its own addresses: {', '.join(sorted(own))}",
                related=[note(text, "netplan gives the robot this address") for text in static[:3]],
            )
