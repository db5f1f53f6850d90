"""The robot uses another domain on the network than its ROS_DOMAIN_ID.

## What it finds
`ExternalDomainId` in a Cyclone DDS file, with a different number than the domain of a process that reads the
file.

## Why it matters on a robot
Machines with the same ROS_DOMAIN_ID do not discover the robot. It shares a domain with machines that nobody
expects there.

## Bad
```xml
<ExternalDomainId>3</ExternalDomainId>   <!-- ROS_DOMAIN_ID=42 -->
```

## Good
```xml
<ExternalDomainId>default</ExternalDomainId>
```

## When to ignore it
If all machines of the fleet use the same mapping on purpose, for example to reach domains above 232.

## References
- Cyclone DDS, configuration reference: Domain/Discovery/ExternalDomainId
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="discovery uses the other ports, and nothing reports that nobody answers there")
def external_domain_id(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        setting = domain.get("Discovery/ExternalDomainId")
        text = (setting.effective or "").strip() if setting else ""
        if setting is None or not text.isdecimal():
            continue
        for reader in robot.dds.readers(configuration):
            if reader.domain is not None and reader.domain != int(text):
                yield finding(
                    setting.value,
                    f"{reader.process.name} has ROS_DOMAIN_ID {reader.domain}, but uses domain {text} on the network",
                    advice="delete ExternalDomainId",
                    related=[note(reader.domain_where or reader.process.place, "the domain of the process")],
                )
                break
