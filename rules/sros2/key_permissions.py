"""Other users on the robot can read a private key.

## What it finds
In a root file system, keys whose mode gives too many users access:
- **error**: the key of the authority, if anyone but its owner has access.
- **warning**: a `key.pem` of an enclave, if every user has access.

sros2 creates both with mode 0644.

## Why it matters on a robot
Every local user and every compromised service can use the identity of the node. With the authority's key they
can create new identities.

## Bad
```text
-rw-r--r-- enclaves/lawn/driver/key.pem
```

## Good
```text
-rw-r----- enclaves/lawn/driver/key.pem
```

## When to ignore it
If the robot has no users and services but those of ROS, or if the mode in the tree is not the mode on the
robot because an installer sets it.

## References
- sros2, tested with the real tool
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", tags=["CWE-732"], symptoms=["key.pem"])
def key_permissions(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("sros2-key"):
        if source.mode is None or not robot.tree.complete:
            continue
        authority = "/private/" in f"/{source.name}"
        if source.mode & (0o077 if authority else 0o007):
            power = "create identities for the whole fleet" if authority else "use the identity of this node"
            yield finding(
                source,
                f"{source.basename} has mode {source.mode:04o}: others on the robot can {power}",
                advice=f"chmod {'600' if authority else '640'}, with the service's group",
                severity="error" if authority or source.mode & 0o004 else None,
            )
