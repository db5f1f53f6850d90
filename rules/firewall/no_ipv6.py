"""IPv6 is not filtered.

## What it finds
iptables rules for incoming packets in a tree that has neither ip6tables nor nftables `inet` rules and does not
disable IPv6. ufw covers both.

## Why it matters on a robot
Every interface has a link-local IPv6 address. Anybody on the same network bypasses the firewall with it.

## Bad
```sh
iptables -P INPUT DROP
```

## Good
```sh
iptables -P INPUT DROP
ip6tables -P INPUT DROP
```

## When to ignore it
When the kernel is built without IPv6, or a router in front of the robot filters it.

## References
- robotics-security guide, firewall
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="accepted packets are not logged")
def no_ipv6(robot: Robot) -> Iterator[Finding]:
    tools = {tool for firewall in robot.firewalls for tool in firewall.tools}
    off = any("ipv6.disable=1" in source.said or "disable_ipv6" in source.said for source in robot.sources)
    if tools & {"ip6tables", "inet", "ufw"} or off:
        return
    for firewall in robot.firewalls:
        if "iptables" in firewall.tools and firewall.drops and firewall.first_input is not None:
            yield finding(
                firewall.first_input,
                "IPv6 is not filtered: these rules are only for IPv4",
                advice="add ip6tables rules, or disable IPv6",
            )
