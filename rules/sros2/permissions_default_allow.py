"""Permissions allow everything that no rule names.

## What it finds
`<default>ALLOW</default>` in a grant of a document that a robot uses.

## Why it matters on a robot
Every topic that no rule denies is open to the enclave, whatever the allow rules list: a compromised node can
command the motors.

## Bad
```xml
<default>ALLOW</default>
```

## Good
```xml
<default>DENY</default>
```

## When to ignore it
While the permissions are still being collected on a network that only the developers can reach, or for a
debugging enclave that is not deployed.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.3
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", silent="nothing is refused, so nothing is reported", tags=["CWE-276"])
def permissions_default_allow(robot: Robot) -> Iterator[Finding]:
    for permissions, grant in robot.sros2.grants:
        if grant.default == "ALLOW" and robot.sros2.is_used(permissions.source):
            yield finding(
                grant.default,
                "The default is ALLOW: the allow rules have no effect, everything that is not denied is permitted",
                advice="write DENY, list what the enclave needs, and sign the document again",
                fix=fix("write DENY", (grant.default, "DENY"), safe=False),
            )
