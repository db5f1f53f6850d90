"""A VLAN id is out of range.

## What it finds
A VLAN `id` outside 1 to 4094:
- **error**: an id above 4094.
- **warning**: id 0, which netplan accepts, but which marks frames without a VLAN.

## Why it matters on a robot
Netplan stops at an id above 4094. Frames with id 0 belong to no VLAN, so the networks are not separated.

## Bad
```yaml
vlan10: {link: eth0, id: 4095}
```

## Good
```yaml
vlan10: {link: eth0, id: 10}
```

## When to ignore it
For id 0, if you only want priority tags (802.1p). An id above 4094 never works.

## References
- IEEE 802.1Q: VID 0 is a priority tag, VID 4095 is reserved
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode


@rule("error", symptoms=["allowed values are 0 to 4094"])
def vlan_id_range(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems(PlanCode.VLAN_ID):
        message = f"VLAN id {problem.where} is out of range: netplan generates nothing"
        yield finding(problem.where, message, advice="choose 1 to 4094")
    for interface in robot.netplan.interfaces:
        number = interface.value("id")
        if interface.kind == "vlans" and number == "0":
            message = "VLAN id 0 marks frames without a VLAN: the networks are not separated"
            yield finding(number, message, advice="choose 1 to 4094", severity="warning")
