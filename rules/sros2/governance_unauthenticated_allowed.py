"""A governance document lets machines without an identity join.

## What it finds
`allow_unauthenticated_participants` set to true in a document that a robot uses.

## Why it matters on a robot
Any machine on the network can join and reach every topic that is not protected. With RTPS protection on, Fast
DDS rejects the document.

## Bad
```xml
<allow_unauthenticated_participants>true</allow_unauthenticated_participants>
```

## Good
```xml
<allow_unauthenticated_participants>false</allow_unauthenticated_participants>
```

## When to ignore it
If an unsecured tool must take part, such as a diagnostic laptop, every topic that matters is protected, and
`rtps_protection_kind` is NONE.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.2.3
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", tags=["CWE-306"], symptoms=["cannot be enabled if rtps_protection_kind is not none"])
def governance_unauthenticated_allowed(robot: Robot) -> Iterator[Finding]:
    for governance in robot.sros2.used_governances:
        for rule_ in governance.rules:
            value = rule_.fields.get("allow_unauthenticated_participants")
            if value is not None and value.lower() in ("true", "1"):
                yield finding(
                    value,
                    "Machines without an identity can join the robot's domain",
                    advice="write false, and sign the document again",
                    fix=fix("write false", (value, "false"), safe=False),
                )
