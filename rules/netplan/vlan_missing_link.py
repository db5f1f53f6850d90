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
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode


@rule("error", symptoms=["is not defined"])
def vlan_missing_link(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems(PlanCode.VLAN_LINK):
        link, later = problem.word, problem.detail
        related = [note(place, "defined here") for place in robot.netplan.declarations(link) if place.path == later]
        if later:
            message, advice = (
                f"'{link}' is defined only in {later}, which sorts later",
                "rename the files so that it is read first",
            )
        else:
            message, advice = f"interface '{link}' is not defined", "define it, even with dhcp4: false"
        yield finding(link, f"{message}: netplan generates nothing", advice=advice, related=related)
