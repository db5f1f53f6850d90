"""Several robots of one site have the same address.

## What it finds
A static IP address, or a MAC address that netplan sets, that more than one robot of a site has. Of IP addresses, only
those of interfaces that lead out of the robot count: Wi-Fi, and interfaces with a default route.

## Why it matters on a robot
Both robots answer ARP for the address. Switches and peers follow whoever spoke last: connections break off in turns,
and a stop command reaches the other robot.

## Bad
```yaml
# alpha and beta: /etc/netplan/10-robot.yaml
network:
  version: 2
  wifis:
    wlan0:
      addresses: [10.0.7.20/24]
```

## Good
```yaml
# alpha has 10.0.7.20/24, beta:
network:
  version: 2
  wifis:
    wlan0:
      addresses: [10.0.7.21/24]
```

## When to ignore it
When the robots are in networks that do not reach each other: give them different sites in fleet.toml.

## References
- [RFC 5227](https://www.rfc-editor.org/rfc/rfc5227): IPv4 address conflict detection
- netplan(5), `addresses`, `macaddress`
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule(
    "error", symptoms=["Dropping address *, as an address conflict was detected.", "IPv6 duplicate address * detected!"]
)
def same_address(fleet: Fleet) -> Iterator[FleetFinding]:
    for subject, what in (("address", "address"), ("mac", "MAC address")):
        for group in fleet.same(subject):
            yield fleet_finding(
                group,
                f"{len(group)} robots of one site have the {what} {group[0].fact.value}: {names(group)}; packets for"
                " one reach another",
                advice="use DHCP with reservations, or give robots that never meet different sites in fleet.toml",
            )
