"""A file that is to switch off the power saving of Wi-Fi leaves it on.

## What it finds
`wifi.powersave=3` in a file for NetworkManager whose name, or a comment that begins with it, says that power
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

VALUE = regex(r"(?m)^[ \t]*wifi\.powersave[ \t]*=[ \t]*(?P<value>\w+)")
OFF = regex(r"(?m)(?:^|[\W_])(?:off|disabled?|no)(?:$|[\W_])")
ORDER = regex(r"[#\s]*(?:disables?|turns? off|switch(?:es)? off)\b(?:(?! if | when | unless |\.[ \t])[^\n])*$")
SAVING = regex(r"power[ _-]?sav")
EXPLAINS = regex(r"\d|enabl|\bon\b|\bto\b|=")
"""A comment on the values, on the opposite, or on what would be done."""


@rule("error", silent="NetworkManager does what the value says")
def power_save_kept(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("networkmanager-wifi"):
        comments = [line for line in source.text.lower().splitlines() if line.lstrip().startswith("#")]
        names = [source.basename.lower(), (source.robot_path or "").rpartition("/")[2].lower()]
        orders = [each for each in comments if ORDER.match(each) and not EXPLAINS.search(each)]
        texts = [*(each for each in names if OFF.search(each)), *orders]
        value = next(reversed(list(VALUE.finditer(source.text))), None)
        if value and value["value"] == "3" and source.judged and any(map(SAVING.search, texts)):
            yield finding(
                source.located(*value.span("value")),
                "This file is to switch power saving off, and 3 enables it",
                advice="write wifi.powersave = 2",
            )
