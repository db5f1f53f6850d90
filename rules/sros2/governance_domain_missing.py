"""The governance document does not cover the robot's domain.

## What it finds
A governance document that does not cover the ROS_DOMAIN_ID of the processes that use its keystore. If no
process names the keystore, the document is compared with the domain that all units, or all files, of the
robot agree on. sros2 writes the domain that was set when the keystore was created, 0 by default.

## Why it matters on a robot
The plugin answers `Could not find domain` (code 141): no participant is created and no node starts.

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
If the keystore belongs to another robot or computer that runs in a domain the document covers.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Could not find domain"])
def governance_domain_missing(robot: Robot) -> Iterator[Finding]:
    for governance in robot.sros2.used_governances:
        missing = robot.sros2.uncovered_domain(governance, governance.rules)
        if missing is None:
            continue
        domain, setting, known = missing
        yield finding(
            known[0].element.tag,
            f"Could not find domain {domain} in governance (code 141), which covers {', '.join(map(str, known))}: no "
            "node starts",
            advice=f"add <id>{domain}</id>, and sign the document again",
            related=[note(setting, "the robot's domain")],
        )
