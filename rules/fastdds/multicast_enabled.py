"""Multicast discovery shows the robot to the whole network.

## What it finds
A default participant profile with neither `avoid_builtin_multicast` nor metatraffic locators, discovery
servers, security or a loopback whitelist. The finding is information, because multicast is the default of
every ROS 2 robot.

## Why it matters on a robot
Every machine on the network sees every topic and can publish on it.

## Bad
```xml
<participant profile_name="robot" is_default_profile="true"/>
```

## Good
```xml
<builtin>
  <metatrafficUnicastLocatorList>
    <locator/>
  </metatrafficUnicastLocatorList>
  <initialPeersList>...</initialPeersList>
</builtin>
```

## When to ignore it
If the robot's network is closed: only its own machines are connected, or a firewall or VLAN separates it.

## References
- Fast DDS documentation, "Disabling all Multicast Traffic"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="discovery works for everybody in the network", tags=["CWE-668"])
def multicast_enabled(robot: Robot) -> Iterator[Finding]:
    closing = {
        "avoid_builtin_multicast",
        "metatrafficUnicastLocatorList",
        "metatrafficMulticastLocatorList",
        "discoveryServersList",
    }
    for profiles in robot.dds.profile_files:
        text = profiles.source.text
        if "dds.sec." in text or "127.0.0.1" in text:
            continue
        for participant in profiles.default_participants:
            if closing.isdisjoint(str(element.name) for element in participant.walk()):
                yield finding(
                    participant.name,
                    "Multicast shows the whole topic graph to every machine on the network",
                    advice="write initialPeersList and metatrafficUnicastLocatorList, or enable security",
                )
