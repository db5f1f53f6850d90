"""A service that stops with its device does not come back with it.

## What it finds
`BindsTo=` on the `.device` unit of a link that a udev rule of the tree makes, where nothing starts the service when the
device appears: no udev rule names it (`ENV{SYSTEMD_WANTS}`), neither it nor a unit that wants it is `WantedBy=` the
device, no script adds it to the device (`systemctl add-wants`), no timer starts it, and no `Upholds=` keeps it up.

## Why it matters on a robot
A cable that slips out, a controller that resets or a hub that loses power for a moment takes the device away. systemd
then stops the service, and `Restart=` does not count for a stop of its own. The device is back a second later, and the
driver is off until somebody logs in.

## Bad
```ini
# the rule: SUBSYSTEM=="tty", ATTRS{serial}=="A1", SYMLINK+="rover_mcu"
[Unit]
BindsTo=dev-rover_mcu.device
After=dev-rover_mcu.device

[Install]
WantedBy=multi-user.target
```

## Good
```ini
# the rule: SUBSYSTEM=="tty", ATTRS{serial}=="A1", SYMLINK+="rover_mcu"
[Unit]
BindsTo=dev-rover_mcu.device
After=dev-rover_mcu.device

[Install]
WantedBy=multi-user.target dev-rover_mcu.device
```

## When to ignore it
When the robot must not move on by itself after a lost connection.

## References
- systemd.unit(5), BindsTo=
- systemd.service(5), Restart=
- systemd.device(5), SYSTEMD_WANTS=
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import host
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit


@rule("warning", silent="systemd stops the service on purpose, and nothing starts it again")
def device_return_ignored(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        word = next((each for each in unit.words("BindsTo") if host.device_path(each)), None)
        if word is None or unit.uncertain:
            continue
        links = robot.udev.links_to(host.device_path(word) or "")
        own = [link for link in links if link.is_fixed and robot.same_robot(link.name, word)]
        if own and not robot.devices.untagged(word) and not _is_started(robot, unit, str(word)):
            yield finding(
                word,
                f"{unit.name} stops when {own[0].path} disappears, and nothing starts it when the device is back",
                advice=f"write WantedBy={word} in [Install], or ENV{{SYSTEMD_WANTS}} in the udev rule",
                related=[note(own[0].name, "this rule makes the link and starts nothing")],
            )


def _is_started(robot: Robot, unit: Unit, device: str) -> bool:
    """Whether something starts the service again: the device, a udev rule, a timer, or a unit that keeps it up."""
    if device in _wanting(robot, unit) or unit.words("UpheldBy", "Install") or unit.name in robot.units.triggered:
        return True
    by_hand = rf"\badd-(?:wants|requires)[ \t][^\n]*{re.escape(device)}|{re.escape(device)}\.(?:wants|requires)\b"
    if robot.mentions(re.compile(by_hand)):
        return True
    stem = unit.name.partition("@")[0].removesuffix(".service")
    if any(stem in source.text for source in robot.of_kind("udev-rules")):
        return True
    return any(unit.name in each.words("Upholds") for each in robot.units.all)


def _wanting(robot: Robot, unit: Unit) -> set[str]:
    """The names of the units that start a unit, or a unit that starts it, by what [Install] says."""
    found: set[str] = set()
    todo = [unit]
    while todo:
        each = todo.pop()
        names = {str(name) for key in ("WantedBy", "RequiredBy") for name in each.words(key, "Install")} - found
        found |= names
        todo += filter(None, (robot.units.find(name, each) for name in names))
    return found
