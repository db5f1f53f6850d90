"""Network services are installed that the robot does not use.

## What it finds
A script or Dockerfile that installs avahi-daemon, cups, snapd, modemmanager, bluetooth or bluez, when nothing else
in the tree refers to it: no `.local` name, no gamepad, no modem.

## Why it matters on a robot
Every service that listens is one more way in. ModemManager also talks to serial devices that are not modems.

## Bad
```sh
apt-get install -y avahi-daemon cups
```

## Good
```sh
apt-get purge -y avahi-daemon cups
```

## When to ignore it
When operators use the service in a way that the tree does not show, for example to find the robot by its `.local`
name.

## References
- robotics-security guide
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

USES = {
    "avahi-daemon": r"\.local\b|avahi|mdns",
    "cups": r"cups|printer",
    "snapd": r"\bsnap",
    "modemmanager": r"modem|wwan|gsm|lte\b",
    "bluetooth": r"bluetooth|bluez|gamepad|joystick|joy_|teleop|ds4|\bble\b",
    "bluez": r"bluetooth|bluez|gamepad|joystick|joy_|teleop|ds4|\bble\b",
}


@rule("info", confidence="medium", silent="the services run as installed")
def packages_unneeded(robot: Robot) -> Iterator[Finding]:
    for source, command in robot.installations:
        for word in command.words:
            uses = USES.get(word.lower())
            others = [other for other in robot.sources if other is not source]
            if uses and not any(re.search(uses, other.text, re.I) for other in others):
                yield finding(
                    word,
                    f"Nothing in this tree uses {word}: it is one more service that listens on the robot",
                    advice=f"do not install it, or purge it: apt-get purge -y {word}",
                )
