"""Several robots of one site have the same host name.

## What it finds
An `/etc/hostname` that more than one robot of a site has.

## Why it matters on a robot
mDNS renames one of them to `name-2.local`, and which one depends on who boots first: `ssh robot.local` reaches another
robot than yesterday. Logs and DHCP leases of both have one name.

## Bad
```text
alpha/etc/hostname: ubuntu
beta/etc/hostname:  ubuntu
```

## Good
```text
alpha/etc/hostname: rover-alpha
beta/etc/hostname:  rover-beta
```

## When to ignore it
When the name is set at each boot by something that the files do not show.

## References
- hostname(5)
- [RFC 6762](https://www.rfc-editor.org/rfc/rfc6762), section 9: conflict resolution
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("warning", symptoms=["Host name conflict, retrying with"])
def same_host_name(fleet: Fleet) -> Iterator[FleetFinding]:
    for group in fleet.same("host-name"):
        name = group[0].fact.value
        yield fleet_finding(
            group,
            f"{len(group)} robots have the host name {name}: {names(group)}; {name}.local is the one that booted first",
            advice="set a name for each robot at the first boot, for example from its serial number",
        )
