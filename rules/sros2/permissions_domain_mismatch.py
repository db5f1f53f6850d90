"""Permissions are for a different domain than the robot's.

## What it finds
An enclave none of whose allow rules covers the ROS_DOMAIN_ID of the processes that use its keystore. If no
process names the keystore, the rules are compared with the domain that all units, or all files, of the robot
agree on. sros2 writes the domain that was set when the enclave was created.

## Why it matters on a robot
The default rule denies the participant (code 145): no node of the enclave starts.

## Bad
```xml
<!-- ROS_DOMAIN_ID=7 -->
<domains>
  <id>0</id>
</domains>
```

## Good
```xml
<!-- ROS_DOMAIN_ID=7 -->
<domains>
  <id>7</id>
</domains>
```

## When to ignore it
If the enclave belongs to a process that runs in another domain, such as a bridge or a second robot that
shares the keystore.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.3
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["participant denied by default rule"])
def permissions_domain_mismatch(robot: Robot) -> Iterator[Finding]:
    for document, grant in robot.sros2.ros_grants:
        missing = robot.sros2.uncovered_domain(document, grant.allowed) if grant.default != "ALLOW" else None
        if missing is None:
            continue
        domain, setting, known = missing
        yield finding(
            known[0].element.tag,
            f"{grant.enclave} is allowed in domain {known[0]}, but the robot runs in {domain}: denied by default "
            "(code 145), its nodes do not start",
            advice=f"write <id>{domain}</id>, and sign the document again",
            related=[note(setting, "the robot's domain")],
        )
