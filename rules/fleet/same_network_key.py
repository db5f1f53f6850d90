"""Several robots have the same key of a VPN or an access point.

## What it finds
A private key of WireGuard, the passphrase of an access point that the robot itself opens, or a password of 802.1X,
that more than one robot has. The passphrase of a Wi-Fi that all clients share is none of these.

## Why it matters on a robot
A WireGuard server sends what is for a key to the address that used it last: with two robots of one key, each cuts the
other off. The passphrase of one access point opens all of them.

## Bad
```ini
# alpha and beta: /etc/wireguard/wg0.conf
[Interface]
PrivateKey = (the same)
```

## Good
```ini
# alpha: /etc/wireguard/wg0.conf
[Interface]
PrivateKey = (made by "wg genkey" on alpha)
```

## When to ignore it
For robots that are spares of each other and never run at the same time.

## References
- wg(8): a peer is its public key, and roams with its last address
- hostapd.conf, `wpa_passphrase`; wpa_supplicant.conf(5), `password`
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names

_WHAT = {
    "vpn-key": ("private key of a VPN", "the server sends what is for one to the other"),
    "access-point": ("passphrase of their access point", "the passphrase of one opens all of them"),
    "wifi-login": ("password of 802.1X", "the network cannot tell them apart, nor shut one out"),
}
"""What is shared, and what it leads to."""


@rule("error", silent="each robot works alone; the last one that connects gets the packets", tags=["CWE-321"])
def same_network_key(fleet: Fleet) -> Iterator[FleetFinding]:
    for group in fleet.shared(*_WHAT):
        what, result = _WHAT[group[0].mark.kind]
        yield fleet_finding(
            group,
            f"{len(group)} robots have the same {what}: {names(group)}; {result}",
            advice="make it on each robot at the first boot, not in the image",
        )
