"""The private key of the certificate authority is on the robot.

## What it finds
In a root file system: a key below `private` of a keystore.

## Why it matters on a robot
Whoever gains control of the robot can create identities for the whole fleet.

## Bad
```text
/etc/lawn/keystore/private/ca.key.pem
```

## Good
```text
/etc/lawn/keystore/public/ca.cert.pem
```

## When to ignore it
If the robot is its own authority, no other robot trusts its certificates, and it must create enclaves on
site.

## References
- ROS 2 documentation, "Deployment Guidelines" of security
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", silent="a key that is not used leaves no trace", tags=["CWE-522"])
def ca_key_on_robot(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("sros2-key"):
        if robot.tree.complete and "/private/" in f"/{source.name}" and source.judged:
            yield finding(
                source,
                "The key of the certificate authority is on the robot: whoever controls it can create identities "
                "for the whole fleet",
                advice="sign on a separate machine, and deploy only public and enclaves",
            )
