"""The firewall accepts every packet that it does not list.

## What it finds
A script or rule file with iptables or nft rules for incoming packets that neither sets a default of DROP nor ends
with one. ufw denies by default once it is enabled.

## Why it matters on a robot
The rules look like protection but are none: every other port of the robot is open.

## Bad
```sh
iptables -A INPUT -p tcp --dport 22 -j ACCEPT
```

## Good
```sh
iptables -P INPUT DROP
iptables -A INPUT -p tcp --dport 22 -j ACCEPT
```

## When to ignore it
When another file that is not in the tree sets the default policy.

## References
- robotics-security guide, firewall
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="accepted packets are not logged")
def default_accept(robot: Robot) -> Iterator[Finding]:
    for firewall in robot.firewalls:
        uses = {"iptables", "nft"} & set(firewall.tools)
        if uses and "ufw" not in firewall.tools and firewall.first_input is not None and not firewall.drops:
            yield finding(
                firewall.first_input,
                "The firewall accepts everything that these rules do not list",
                advice="set the default: iptables -P INPUT DROP, or policy drop",
            )
