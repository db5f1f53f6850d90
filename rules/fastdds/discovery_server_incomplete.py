"""A Fast DDS discovery client without server.

## What it finds
A default participant with `discoveryProtocol` `CLIENT` or `SUPER_CLIENT` and no `discoveryServersList`.
`ROS_DISCOVERY_SERVER` in an environment that the tree does not show may name one, so the confidence is
medium.

## Why it matters on a robot
A client talks to its servers only: without one it finds nobody.

## Bad
```xml
<discoveryProtocol>CLIENT</discoveryProtocol>
```

## Good
```xml
<discoveryProtocol>CLIENT</discoveryProtocol>
<discoveryServersList>...</discoveryServersList>
```

## References
- Fast DDS documentation, "Discovery Server Settings"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", confidence="medium")
def discovery_server_incomplete(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        for profile in profiles.of_kind("participant"):
            for element in profile.element.walk() if profile.is_default and not profiles.dropped else ():
                if element.name != "discovery_config" or element.find("discoveryServersList") is not None:
                    continue
                protocol = element.find("discoveryProtocol")
                if protocol is not None and protocol.text in ("CLIENT", "SUPER_CLIENT"):
                    yield finding(
                        protocol.text,
                        f"A {protocol.text} without a server finds nobody",
                        advice="add discoveryServersList, or choose SIMPLE",
                    )
