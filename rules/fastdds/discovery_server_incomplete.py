"""A Fast DDS discovery client has no server.

## What it finds
A default participant with `discoveryProtocol` `CLIENT` or `SUPER_CLIENT` and without `discoveryServersList`.
The confidence is medium, because an environment outside the tree may set `ROS_DISCOVERY_SERVER`.

## Why it matters on a robot
A client contacts only its servers: without one it discovers no other participant.

## Bad
```xml
<discoveryProtocol>CLIENT</discoveryProtocol>
```

## Good
```xml
<discoveryProtocol>CLIENT</discoveryProtocol>
<discoveryServersList>...</discoveryServersList>
```

## When to ignore it
If `ROS_DISCOVERY_SERVER` is set where the robot is started, outside the tree.

## References
- Fast DDS documentation, "Discovery Server Settings"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", confidence="medium", symptoms=["Discovery Server requires to specify a listening address."])
def discovery_server_incomplete(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        for participant in profiles.default_participants:
            for element in participant.walk():
                if element.name != "discovery_config" or element.find("discoveryServersList") is not None:
                    continue
                protocol = element.find("discoveryProtocol")
                if protocol is not None and protocol.text in ("CLIENT", "SUPER_CLIENT"):
                    yield finding(
                        protocol.text,
                        f"A {protocol.text} without a server discovers no other participant",
                        advice="add discoveryServersList, or choose SIMPLE",
                    )
