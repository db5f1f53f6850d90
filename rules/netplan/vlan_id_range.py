"""A VLAN id out of range.

## What it finds
A VLAN `id` above 4094. As a warning: id 0, which netplan takes, but which marks frames without a VLAN.

## Why it matters on a robot
Netplan stops at an id above 4094. Frames with id 0 belong to no VLAN: the separation that was meant is not
there.

## Bad
```yaml
vlan10: {link: eth0, id: 4095}
```

## Good
```yaml
vlan10: {link: eth0, id: 10}
```

## References
- IEEE 802.1Q: VID 0 is a priority tag, VID 4095 is reserved
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["allowed values are 0 to 4094"])
def vlan_id_range(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems("vlan-id"):
        message = f"VLAN id {problem.where} is out of range: netplan generates nothing"
        yield finding(problem.where, message, advice="choose 1 to 4094")
    for interface in robot.netplan.interfaces:
        number = interface.value("id")
        if interface.kind == "vlans" and number == "0":
            message = "VLAN id 0 marks frames that belong to no VLAN"
            yield finding(number, message, advice="choose 1 to 4094", severity="warning")
