"""Multicast discovery shows the robot to the whole network.

## What it finds
`AllowMulticast` that is missing, `true`, `default` or contains `asm`, in a block that is neither limited to
the loopback interface nor secured. The finding is information, because multicast is the default of every ROS
2 robot.

## Why it matters on a robot
Every machine on the network sees every topic and can publish on it. Domain numbers separate robots, but do
not keep anyone out.

## Bad
```xml
<AllowMulticast>true</AllowMulticast>
```

## Good
```xml
<AllowMulticast>false</AllowMulticast>
<!-- with Discovery/Peers and ParticipantIndex auto -->
```

## When to ignore it
If the robot's network is closed: only its own machines are connected, or a firewall or VLAN separates it.

## References
- Cyclone DDS, configuration guide, "AllowMulticast"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import multicast_off
from bringup_lint.api.cyclonedds import on_loopback_only


@rule("info", silent="discovery works for everybody in the network", tags=["CWE-668"])
def multicast_enabled(robot: Robot) -> Iterator[Finding]:
    for _, domain in robot.dds.domains:
        if domain.element is None or on_loopback_only(domain) or domain.found("Security"):
            continue
        setting = domain.get("General/AllowMulticast")
        words = (setting.effective or "$").lower().split(",") if setting else ["default"]
        interfaces = domain.found("General/Interfaces/NetworkInterface")
        if not {"true", "default", "asm"} & set(words) or (interfaces and multicast_off(domain)):
            continue
        where = setting.value if setting and setting.value else domain.element.name
        yield finding(
            where,
            "Multicast shows the whole topic graph to every machine on the network",
            advice="write AllowMulticast false (or spdp) and list the Peers, or enable DDS security",
        )
