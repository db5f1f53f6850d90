"""cloud-init's file still switches on DHCP for an interface with a static address.

## What it finds
A file of cloud-init (`50-cloud-init.yaml`) with `dhcp4: true` for an interface to which another file gives an
address, unless a later file sets `dhcp4: false`.

## Why it matters on a robot
Netplan merges files key by key, so the static address does not replace DHCP. The robot gets two addresses and
two default routes, and waits for a DHCP server that does not exist.

## Bad
```yaml
# 50-cloud-init.yaml
network: {ethernets: {eth0: {dhcp4: true}}}
# 60-robot.yaml
network: {ethernets: {eth0: {addresses: [10.0.0.10/24]}}}
```

## Good
```yaml
# 60-robot.yaml, the only file
network: {ethernets: {eth0: {dhcp4: false, addresses: [10.0.0.10/24]}}}
```

## When to ignore it
If the interface should have both addresses, for example a fixed one for the sensors and one from the site's
DHCP server.

## References
- netplan-generate(8), "Handling multiple files"
- cloud-init documentation, "Disabling network configuration"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", silent="netplan merges both files without a message")
def cloud_init(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        flag = interface.flag("dhcp4")
        if flag is None or not flag.value or "cloud-init" not in flag.where.span.source.basename:
            continue
        own = [address for address in interface.addresses if address.text.path != flag.where.path]
        if own:
            yield finding(
                flag.where,
                f"{flag.where.span.source.basename} gives {interface.name} DHCP in addition to its static address",
                advice="disable cloud-init's network configuration and delete the file, or set dhcp4: false",
                related=[note(own[0].text, "the static address")],
            )
