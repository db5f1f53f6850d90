"""The number in the name of a VLAN differs from its id.

## What it finds
A VLAN with a name such as `vlan10` or `eth0.10` and another id.

## Why it matters on a robot
It works, but misleads whoever looks for the control network on the robot.

## Bad
```yaml
vlan10: {link: eth0, id: 20}
```

## Good
```yaml
vlan20: {link: eth0, id: 20}
```

## When to ignore it
If the number in the name has another meaning, such as that of the robot or the port.

## References
- IEEE 802.1Q
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

NUMBERED = regex(r"(?:vlan[._-]?|.+\.)0*([1-9]\d*|0)", re.IGNORECASE)


@rule("info", silent="the name has no meaning for netplan")
def vlan_name_id_mismatch(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        named = NUMBERED.fullmatch(interface.name)
        number = interface.value("id")
        if interface.kind == "vlans" and named and number and number.isdecimal() and int(named[1]) != int(number):
            yield finding(
                interface.name,
                f"{interface.name} has id {number}",
                advice=f"rename it to vlan{number}, or correct the id",
                related=[note(number, "the id")],
            )
