"""The boot waits two minutes for an interface that may be unplugged.

## What it finds
A Wi-Fi interface, or a wired one that uses DHCP, without `optional:`. Another wired interface has a static
address, and a unit is ordered after `network-online.target`.

## Why it matters on a robot
networkd's wait-online waits for every interface that is not optional. Without the cable, or out of range of
the access point, the robot's units start after 120 seconds.

## Bad
```yaml
ethernets:
  eth0: {addresses: [10.0.0.10/24]}
  eth1: {dhcp4: true}
```

## Good
```yaml
ethernets:
  eth0: {addresses: [10.0.0.10/24]}
  eth1: {dhcp4: true, optional: true}
```

## When to ignore it
If DDS uses this interface: then the robot has to wait for it.

## References
- netplan YAML reference, "optional"
- systemd-networkd-wait-online.service(8)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.yaml import first_key


@rule(
    "info",
    fix="unsafe",
    symptoms=["Timeout occurred while waiting for network connectivity", "systemd-networkd-wait-online.service"],
)
def not_optional_unplugged(robot: Robot) -> Iterator[Finding]:
    waiting = robot.waiting_for_network
    plan = robot.netplan.only_plan
    if not waiting or plan is None or not plan.is_waited_for:
        return
    fixed = [i for i in plan.interfaces.values() if i.addresses and not i.is_wifi]
    for interface in plan.interfaces.values():
        dynamic = interface.is_wifi or (interface.kind == "ethernets" and interface.dhcp4 and not interface.addresses)
        if not dynamic or not interface.is_configured or interface.optional is not None or not fixed:
            continue
        name, word = waiting[0]
        yield finding(
            interface.name,
            f"Without a link on {interface.name}, {name} starts two minutes late",
            advice="set optional: true, unless DDS needs this interface",
            related=[note(word, f"{name} waits for the network here")],
            fix=fix("set optional: true", first_key(interface.definitions[0].body, "optional: true"), safe=False),
        )
