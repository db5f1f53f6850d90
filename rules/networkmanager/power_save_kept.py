"""A file that is to switch off the power saving of Wi-Fi leaves it on.

## What it finds
`wifi.powersave=3` in a file for NetworkManager whose name, or a comment that speaks of nothing else, says that power
saving is off or disabled.

## Why it matters on a robot
The values are easily confused: 2 disables power saving, and 3 enables it. With power saving the adapter sleeps
between the beacons of the access point: commands and map data arrive hundreds of milliseconds late, in bursts.

## Bad
```ini
# wifi-powersave-off.conf
[connection]
wifi.powersave = 3
```

## Good
```ini
# wifi-powersave-off.conf
[connection]
wifi.powersave = 2
```

## When to ignore it
When only the name is wrong, and the robot is to save power.

## References
- NetworkManager.conf(5), "Connection section"
- https://networkmanager.dev/docs/libnm/latest/libnm-nm-dbus-interface.html (NMSettingWirelessPowersave)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

VALUE = regex(r"(?m)^[ \t]*wifi\.powersave[ \t]*=[ \t]*(?P<value>3)\b")
OFF = regex(r"(?m)(?:^|[\W_])(?:off|disabled?|no)(?:$|[\W_])|\b(?:disables?|turns? off|switch(?:es)? off)\b")
SAVING = regex(r"power[ _-]?sav")
EXPLAINS = regex(r"\d|enabl|\bon\b")
"""A comment on the values, or on the opposite."""


@rule("error", silent="NetworkManager does what the value says")
def power_save_kept(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("networkmanager-wifi"):
        comments = [line for line in source.text.lower().splitlines() if line.lstrip().startswith("#")]
        names = [source.basename.lower(), (source.robot_path or "").rpartition("/")[2].lower()]
        texts = [*names, *(each for each in comments if not EXPLAINS.search(each))]
        value = VALUE.search(source.text)
        if value and source.judged and any(SAVING.search(text) and OFF.search(text) for text in texts):
            yield finding(
                source.located(*value.span("value")),
                "This file is to switch power saving off, and 3 enables it",
                advice="write wifi.powersave = 2",
            )
