"""cloud-init's file still gives an interface DHCP beside the robot's own file.

## What it finds
`50-cloud-init.yaml` with `dhcp4: true` for an interface to which another file of the same folder gives a
static address, without setting `dhcp4` itself.

## Why it matters on a robot
Netplan merges files key by key: the static address does not replace DHCP, it comes beside it. The robot
gets two addresses and two default routes, and waits for a DHCP server that is not there.

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


@rule("info")
def cloud_init(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        flag = interface.flag("dhcp4")
        if flag is None or not flag.value or "cloud-init" not in flag.where.span.source.basename:
            continue
        own = [address for address in interface.addresses if address.text.path != flag.where.path]
        if own:
            yield finding(
                flag.where,
                f"{flag.where.span.source.basename} gives {interface.name} DHCP beside its static address",
                advice="disable cloud-init's network configuration and delete the file, or set dhcp4: false",
                related=[note(own[0].text, "the static address")],
            )
