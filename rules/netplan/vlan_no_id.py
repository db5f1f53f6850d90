"""A VLAN has no id.

## What it finds
An entry below `vlans:` without `id`.

## Why it matters on a robot
Netplan stops and configures nothing. It does not derive the id from the name of the VLAN.

## Bad
```yaml
vlan10: {link: eth0}
```

## Good
```yaml
vlan10: {link: eth0, id: 10}
```

## When to ignore it
Never: `netplan generate` stops here and configures nothing.

## References
- netplan YAML reference, "Properties for device type vlans:"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode


@rule("error", symptoms=["missing 'id' property"])
def vlan_no_id(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems(PlanCode.VLAN_NO_ID):
        number = "".join(char for char in problem.word if char.isdecimal())
        yield finding(
            problem.where,
            f"{problem.where} has no id: netplan generates nothing",
            advice=f"add id: {number}" if number else "add its id",
        )
