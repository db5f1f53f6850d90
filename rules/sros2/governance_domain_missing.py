"""A governance document that does not cover the robot's domain.

## What it finds
A governance document of the robot without the ROS_DOMAIN_ID that the tree sets, when all its files agree on
one. sros2 writes the domain of the moment at which the keystore was created, 0 by default.

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

## References
- Cyclone DDS 0.10.5 with security, tried with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Could not find domain"])
def governance_domain_missing(robot: Robot):
    if robot.dds_domain is None:
        return
    domain, setting = robot.dds_domain
    for governance in robot.sros2.used_governances:
        known = [rule_.domains for rule_ in governance.rules if rule_.domains is not None]
        if not known or any(each.covers(domain) for each in known):
            continue
        yield finding(
            known[0].element.tag,
            f"Could not find domain {domain} in governance (code 141), which covers {', '.join(map(str, known))}: no "
            "node starts",
            advice=f"add <id>{domain}</id>, and sign the document again",
            related=[note(setting, "the robot's domain")],
        )
