"""hostapd is given a channel of the other band.

## What it finds
`hw_mode=g` or `b` (2.4 GHz) with a channel above 14, and `hw_mode=a` (5 GHz) with a channel up to 14, in hostapd.conf.

## Why it matters on a robot
hostapd finds no such channel and ends: the robot opens no access point, and nobody reaches it in the field.

## Bad
```
hw_mode=g
channel=36
```

## Good
```
hw_mode=a
channel=36
```

## When to ignore it
Never: with `channel=0` hostapd chooses one itself.

## References
- hostapd.conf(5), "hw_mode" and "channel"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.host import option_of

BANDS = {"g": (1, 14, "2.4 GHz"), "b": (1, 14, "2.4 GHz"), "a": (15, 233, "5 GHz")}
NUMBER = regex(r"[1-9]\d{0,2}")


@rule(
    "error",
    symptoms=[
        "not found from the channel list of",
        "Hardware does not support configured channel",
        "Could not select hw_mode and channel",
    ],
)
def access_point_channel(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("hostapd"):
        if not source.judged or source.template:
            continue
        mode, channel = option_of(source, "hw_mode"), option_of(source, "channel")
        if option_of(source, "op_class") is not None:
            continue  # it chooses the band, such as 6 GHz
        if mode is None or channel is None or mode not in BANDS or not NUMBER.fullmatch(channel):
            continue
        first, last, band = BANDS[mode]
        if not first <= int(channel) <= last:
            yield finding(
                channel,
                f"hw_mode={mode} is {band}, which has no channel {channel}: hostapd does not start",
                advice="write hw_mode=a" if first == 1 else "write hw_mode=g",
                related=[note(mode, "the band is chosen here")],
            )
