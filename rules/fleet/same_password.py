"""Several robots have the same password hash.

## What it finds
A hash in `/etc/shadow`, salt included, that more than one robot has for the same user.

## Why it matters on a robot
Salts are random: two equal hashes were copied with the image. Whoever learns the password of one robot, or finds it in
the image, logs in on every robot.

## Bad
```text
alpha/etc/shadow: robot:$6$salt$hash:...
beta/etc/shadow:  robot:$6$salt$hash:...
```

## Good
```text
alpha/etc/shadow: robot:!:...        (locked; SSH keys log in)
beta/etc/shadow:  robot:!:...
```

## When to ignore it
On robots that are never reached from outside of one locked room.

## References
- shadow(5), passwd(1) `-l`
- CWE-798: use of hard-coded credentials
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("warning", silent="no program compares the robots", tags=["CWE-798"])
def same_password(fleet: Fleet) -> Iterator[FleetFinding]:
    for group in fleet.shared("password"):
        yield fleet_finding(
            group,
            f"{len(group)} robots have the same password hash for user {group[0].mark.name}: {names(group)}; the"
            " password of one logs in on all",
            advice="lock the password in the image (passwd -l) and log in with SSH keys, or set one for each robot",
        )
