"""A private key that others on the robot can read.

## What it finds
In a root file system: a `key.pem` that every user can read, and a CA key that anybody but its owner can read.
sros2 leaves both with mode 0644.

## Why it matters on a robot
Every local user and every compromised service can take the identity of the node, or with the CA's key make new
ones.

## Bad
```text
-rw-r--r-- enclaves/lawn/driver/key.pem
```

## Good
```text
-rw-r----- enclaves/lawn/driver/key.pem
```

## References
- sros2, tried with the real tool
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", tags=["CWE-732"], symptoms=["key.pem"])
def key_permissions(robot: Robot):
    for source in robot.of_kind("sros2-key"):
        if source.mode is None or not robot.tree.complete:
            continue
        authority = "/private/" in f"/{source.name}"
        if source.mode & (0o077 if authority else 0o007):
            power = "make identities for the whole fleet" if authority else "take the identity of this node"
            yield finding(
                source,
                f"{source.basename} has mode {source.mode:04o}: others on the robot can {power}",
                advice=f"chmod {'600' if authority else '640'}, with the service's group",
                severity="error" if authority else None,
            )
