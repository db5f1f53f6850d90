"""No bit rate is set for a CAN interface.

## What it finds
A `.network` file with a [CAN] section that has no [Match] section or no `BitRate=`. In a whole root file system
also a `canN` that a unit, environment file, launch file or parameter file names as its CAN interface, when no
`.network` file, script or unit sets its bit rate.

## Why it matters on a robot
A CAN interface without a bit rate cannot be brought up: `RTNETLINK answers: Invalid argument`, and the motor driver
does not start. networkd ignores a file without [Match].

## Bad
```ini
[CAN]
BitRate=500K
```

## Good
```ini
[Match]
Name=can0

[CAN]
BitRate=500K
```

## When to ignore it
When a program of the vendor, which is not in the tree, sets the bit rate before the driver starts.

## References
- systemd.network(5), "[CAN] Section Options"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "bit-timing not yet defined",
        "RTNETLINK answers: Invalid argument",
        "No valid settings found in the [Match] section",
        "RTNETLINK answers: Operation not supported",
        "Network is down",
    ],
)
def not_configured(robot: Robot) -> Iterator[Finding]:
    for file in robot.can.files:
        if not file.matches:
            yield finding(
                file.header,
                "networkd ignores this file: it has no [Match] section that names an interface",
                advice="add [Match] with Name=can0",
            )
        elif not file.has_bit_rate:
            yield finding(
                file.header,
                "The CAN interface gets no bit rate and cannot be brought up",
                advice="add BitRate=500K, or the bit rate of your bus",
            )
    for name, place in robot.can.unconfigured:
        yield finding(
            place,
            f"{name} is used, but nothing sets its bit rate: the driver cannot start",
            advice=f"add a .network file with [Match] Name={name} and [CAN] BitRate=",
        )
