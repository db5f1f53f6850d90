"""Several robots have the same machine id.

## What it finds
An `/etc/machine-id` that more than one robot has.

## Why it matters on a robot
systemd-networkd derives the DHCP client identifier from the machine id, so cloned robots get one lease and take the
address from each other. Journals that are gathered from the fleet mix as if one robot had written them.

## Bad
```text
alpha/etc/machine-id: 0b8f1c7e6d5a4f3e9c2b1a0f8e7d6c5b
beta/etc/machine-id:  0b8f1c7e6d5a4f3e9c2b1a0f8e7d6c5b
```

## Good
```text
alpha/etc/machine-id: 0b8f1c7e6d5a4f3e9c2b1a0f8e7d6c5b
beta/etc/machine-id:  5e2d9a1c4b7f4862a3d0c1e9f8b7a6d5
```

## When to ignore it
For two snapshots of one robot. Give each robot once.

## References
- machine-id(5): an image that is cloned has an empty file, or one that says `uninitialized`
- systemd.network(5), `DUIDType=`
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("error", silent="each robot works alone; no program compares them")
def same_machine_id(fleet: Fleet) -> Iterator[FleetFinding]:
    for group in fleet.shared("machine-id"):
        yield fleet_finding(
            group,
            f"{len(group)} robots have the same machine id: {names(group)}; DHCP takes them for one machine, and so do"
            " journals",
            advice="empty /etc/machine-id in the image; systemd fills it in at the first boot",
        )
