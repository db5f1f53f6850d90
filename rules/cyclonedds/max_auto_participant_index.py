"""A participant index that leaves the ports of its domain.

## What it finds
`MaxAutoParticipantIndex` or `ParticipantIndex` above 119. The ports of a domain end there: index 120
uses ports of the next domain. The finding is for information: it hurts only when that domain is used
too.

## Why it matters on a robot
Every peer is asked at as many ports as there are indices, at each announcement, and the highest ports
belong to the next domain: robots of neighbouring domains meet there.

## Bad
```xml
<MaxAutoParticipantIndex>500</MaxAutoParticipantIndex>
```

## Good
```xml
<MaxAutoParticipantIndex>100</MaxAutoParticipantIndex>
```

## References
- DDSI-RTPS 2.5, section 9.6.2.3: port 7400 + 250 x domain + 2 x participant + 10
- https://github.com/ros2/rmw_cyclonedds/issues/458
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", symptoms=["Failed to find a free participant index for domain"])
def max_auto_participant_index(robot: Robot):
    for _, domain in robot.dds.domains:
        for path in ("Discovery/MaxAutoParticipantIndex", "Discovery/ParticipantIndex"):
            setting = domain.get(path)
            text = setting.effective if setting else None
            if text and text.isdigit() and 119 < int(text) < 100000 and not domain.found("Discovery/Ports"):
                port = 7400 + 10 + 2 * int(text)
                yield finding(
                    setting.value,
                    f"Index {text} means port {port} + 250 x domain, which belongs to the next domain (from "
                    f"{7400 + 250})",
                    advice="stay at or below 119",
                )
