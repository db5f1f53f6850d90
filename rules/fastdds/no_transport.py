"""A Fast DDS participant has no transport.

## What it finds
A default participant with `useBuiltinTransports` `false` and neither `userTransports` nor
`builtinTransports`.

## Why it matters on a robot
The library cannot create the default participant: no ROS node starts.

## Bad
```xml
<useBuiltinTransports>false</useBuiltinTransports>
```

## Good
```xml
<useBuiltinTransports>false</useBuiltinTransports>
<userTransports>
  <transport_id>lan</transport_id>
</userTransports>
```

## When to ignore it
Never: the library cannot create the participant.

## References
- Fast DDS 2.14.5, tested with the real library: exit status 1
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["There are not any transports"])
def no_transport(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        for participant in profiles.default_participants:
            rtps = participant.find("rtps")
            switch = rtps.find("useBuiltinTransports") if rtps is not None else None
            if rtps is None or switch is None or switch.text not in ("false", "0"):
                continue
            if rtps.find("userTransports") is None and rtps.find("builtinTransports") is None:
                yield finding(
                    switch.text,
                    "No transport is left: no participant can be created, no node starts",
                    advice="name a transport in userTransports, or delete useBuiltinTransports",
                )
