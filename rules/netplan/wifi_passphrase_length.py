"""A Wi-Fi passphrase is too short or too long.

## What it finds
A WPA passphrase with fewer than 8 or more than 63 characters that is not a key of 64 hexadecimal digits, on
an interface that networkd renders.

## Why it matters on a robot
Netplan stops and configures nothing: the robot has no network, not only no Wi-Fi.

## Bad
```yaml
access-points:
  depot: {password: depot7}
```

## Good
```yaml
access-points:
  depot: {password: warehouse-7}
```

## When to ignore it
Never: the standard does not allow such a passphrase.

## References
- IEEE 802.11, passphrase of 8 to 63 ASCII characters
- wpa_supplicant.conf(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode
from bringup_lint.api.templates import is_stand_in


@rule(
    "error",
    symptoms=[
        "ASCII passphrase must be between 8 and 63 characters",
        "PSK length of 64 is only supported for hex-digit",
    ],
)
def wifi_passphrase_length(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems(PlanCode.PASSPHRASE):
        where = problem.word
        if is_stand_in(where):
            continue
        yield finding(
            where,
            f"A WPA passphrase has 8 to 63 characters, this one is not valid ({problem.detail}): netplan stops",
            advice="correct the passphrase",
            secrets=[where],
        )
