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
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode


@rule("error", symptoms=["is not defined"])
def undefined_interface(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems(PlanCode.UNDEFINED):
        name, later = problem.word, problem.detail
        related = [note(place, "defined here") for place in robot.netplan.declarations(name) if place.path == later]
        if later:
            message, advice = (
                f"'{name}' is defined only in {later}, which sorts later",
                "rename the files so that it is read first",
            )
        else:
            message, advice = f"interface '{name}' is not defined", "define it, even with dhcp4: false"
        yield finding(name, f"{message}: netplan generates nothing", advice=advice, related=related)
