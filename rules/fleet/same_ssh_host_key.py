"""Several robots have the same SSH host key.

## What it finds
An SSH host key in `/etc/ssh` that more than one robot has. Public and private halves count alike.

## Why it matters on a robot
An image was cloned with its keys. Whoever takes the key from one robot can pretend to be every other one, and nobody
who logs in sees a warning: the key is the one that is expected.

## Bad
```text
alpha/etc/ssh/ssh_host_ed25519_key.pub: ssh-ed25519 AAAAC3...same
beta/etc/ssh/ssh_host_ed25519_key.pub:  ssh-ed25519 AAAAC3...same
```

## Good
```text
alpha/etc/ssh/ssh_host_ed25519_key.pub: ssh-ed25519 AAAAC3...one
beta/etc/ssh/ssh_host_ed25519_key.pub:  ssh-ed25519 AAAAC3...other
```

## When to ignore it
For two snapshots of one robot. Give each robot once.

## References
- sshd_config(5), `HostKey`; ssh-keygen(1), `-A`
- [cloud-init: ssh_deletekeys](https://cloudinit.readthedocs.io/en/latest/reference/modules.html#ssh)
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("error", silent="an SSH client accepts every robot as the known one", tags=["CWE-321"])
def same_ssh_host_key(fleet: Fleet) -> Iterator[FleetFinding]:
    for group in fleet.shared("ssh-host-key"):
        yield fleet_finding(
            group,
            f"{len(group)} robots have the same SSH host key ({group[0].mark.name}): {names(group)}; who reads it on"
            " one can pretend to be any of them",
            advice="delete /etc/ssh/ssh_host_* from the image and make keys at the first boot: ssh-keygen -A",
        )
