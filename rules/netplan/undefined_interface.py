"""A bridge, bond or other interface refers to one that is not defined.

## What it finds
A member of a bridge, bond or VRF, a `primary`, a `link` or a `peer` that is defined neither in the same file
nor in an earlier one. netplan reads files in the order of their names. The `link` of a VLAN has its own rule.

## Why it matters on a robot
Netplan stops and configures nothing.

## Bad
```yaml
bridges:
  br0: {interfaces: [eth0]}
```

## Good
```yaml
ethernets:
  eth0: {dhcp4: false}
bridges:
  br0: {interfaces: [eth0]}
```

## When to ignore it
Only if the interface is defined in a file that is not in the tree and that netplan reads earlier, such as one
of cloud-init.

## References
- netplan YAML reference, "interfaces"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode
from bringup_lint.api.netplan import undefined_names


@rule("error", symptoms=["is not defined", "Error in network definition: *: interface * is not defined"])
def undefined_interface(robot: Robot) -> Iterator[Finding]:
    yield from undefined_names(robot.netplan, PlanCode.UNDEFINED)
