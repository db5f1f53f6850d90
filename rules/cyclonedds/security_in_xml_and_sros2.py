"""Security is configured twice: in the Cyclone DDS file and by SROS2.

## What it finds
A `Security` group in a Cyclone DDS file that a process with `ROS_SECURITY_ENABLE=true` reads.

## Why it matters on a robot
The middleware passes the files of the keystore as properties of the participant, and the library rejects or
overrides one of the two configurations. The version of the library decides which identity the robot has.

## Bad
```xml
<Security><Authentication><Library path="dds_security_auth"/></Authentication></Security>
```

## Good
```sh
ROS_SECURITY_ENABLE=true
ROS_SECURITY_KEYSTORE=/etc/lawn/keystore
```

## When to ignore it
If you have tested this combination with the library version of the robot, and the version is pinned.

## References
- rmw_cyclonedds, how security is configured
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", silent="only a trace of discovery says which settings Cyclone DDS uses")
def security_in_xml_and_sros2(robot: Robot) -> Iterator[Finding]:
    for process in robot.ros.processes:
        enable = process.environment.get("ROS_SECURITY_ENABLE")
        if enable is None or enable.text != "true":
            continue
        for domain in robot.dds.domains_of(process):
            for place in domain.found("Security")[:1]:
                yield finding(
                    place.name,
                    f"Security of {process.name} is configured here and by its keystore: the two conflict",
                    advice="delete the Security group",
                    related=[note(enable.value, "SROS2 is switched on here")],
                )
