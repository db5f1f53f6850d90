"""The link of a VLAN is not defined.

## What it finds
A VLAN whose `link` names an interface that is defined neither in the same file nor in an earlier one. netplan
finishes each file before it reads the next, so a definition in a later file does not help.

## Why it matters on a robot
Netplan stops: no interface is configured, not just the VLAN.

## Bad
```yaml
vlans:
  vlan10: {id: 10, link: eth0}
```

## Good
```yaml
ethernets:
  eth0: {dhcp4: false}
vlans:
  vlan10: {id: 10, link: eth0}
```

## When to ignore it
Only if the interface is defined in a file that is not in the tree and that netplan reads earlier, such as one
of cloud-init.

## References
- netplan YAML reference, "link"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode
from bringup_lint.api.netplan import undefined_names


@rule("error", symptoms=["is not defined"])
def vlan_missing_link(robot: Robot) -> Iterator[Finding]:
    yield from undefined_names(robot.netplan, PlanCode.VLAN_LINK)
