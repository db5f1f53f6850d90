"""dnsmasq gives out addresses of another network than that of its interface.

## What it finds
A `dhcp-range=` of dnsmasq that begins outside of every network of the interface that its file names with `interface=`,
where netplan or dhcpcd.conf gives that interface a fixed address, and no other file of the tree has an address of the
range's network; and a range whose end is below its start.

## Why it matters on a robot
dnsmasq answers on an interface only from a range of a network that the interface has: the log says "no address range
available for DHCP request", the tablet of the operator joins the access point and gets no address. Nobody reaches the
robot in the field.

## Bad
```
# netplan: wlan0 has 192.168.4.1/24
interface=wlan0
dhcp-range=192.168.50.10,192.168.50.100,12h
```

## Good
```
interface=wlan0
dhcp-range=192.168.4.10,192.168.4.100,12h
```

## When to ignore it
When a relay forwards requests of that network.

## References
- dnsmasq(8), "--dhcp-range"
- dnsmasq 2.90, dhcp.c: complete_context()
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.host import LostRange
from bringup_lint.api.host import lost_ranges


@rule(
    "error",
    confidence="medium",
    symptoms=["no address range available for DHCP request via", "inconsistent DHCP range"],
)
def dhcp_range_lost(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("dnsmasq"):
        if source.judged and not source.template:
            yield from map(_finding, lost_ranges(robot.files, lambda: robot.netplan, source))


def _finding(lost: LostRange) -> Finding:
    if lost.address is None:
        return finding(
            lost.first, "The range ends below its start: dnsmasq does not start", advice="swap the two addresses"
        )
    return finding(
        lost.first,
        f"{lost.interface} has {lost.address}: dnsmasq gives nobody an address of this range there",
        advice="take a range of the interface's network",
        related=[note(lost.address, f"the address of {lost.interface}")],
    )
