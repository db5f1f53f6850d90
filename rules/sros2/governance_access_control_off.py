"""The governance document switches access control off.

## What it finds
`enable_join_access_control` set to false, or read or write access control set to false for topics that move
or stop the robot, in a document that a robot uses.

## Why it matters on a robot
The permissions documents are not enforced: every enclave may do everything, whatever its grant allows.

## Bad
```xml
<enable_join_access_control>false</enable_join_access_control>
```

## Good
```xml
<enable_join_access_control>true</enable_join_access_control>
```

## When to ignore it
During commissioning, while the permissions are still being collected, on a network that only the developers
can reach. For topics that are meant to be open to all authenticated nodes, narrow the topic rule instead.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.sros2 import moves_robot


@rule("error", fix="unsafe", silent="nothing is refused, so nothing is reported", tags=["CWE-862"])
def governance_access_control_off(robot: Robot) -> Iterator[Finding]:
    for governance in robot.sros2.used_governances:
        for rule_ in governance.rules:
            off = [(rule_.fields.get("enable_join_access_control"), "joining the domain")]
            for topics in rule_.topic_rules:
                if topics.expression is not None and moves_robot(topics.expression):
                    for way, name in (("subscribing to", "read"), ("publishing on", "write")):
                        value = topics.fields.get(f"enable_{name}_access_control")
                        off.append((value, f"{way} {topics.expression}"))
            for value, what in off:
                if value is not None and value.lower() in ("false", "0"):
                    yield finding(
                        value,
                        f"Access control is off: permissions are not checked for {what}",
                        advice="write true, and sign the document again",
                        fix=fix("write true", (value, "true"), safe=False),
                    )
