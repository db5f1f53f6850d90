"""The access point stays off because its package masks it.

## What it finds
A script that installs `hostapd` with apt and writes its configuration, or enables or starts it, where no script of the
tree says `unmask`. Info where a comment of the script does: somebody took the access point out.

## Why it matters on a robot
The package of Debian, Ubuntu and Raspberry Pi OS masks `hostapd.service` when it is installed without a configuration.
`systemctl enable hostapd` then fails with "Unit file is masked", and without it nothing starts the service: the robot
has no access point, and far from any other network nobody reaches it.

## Bad
```sh
sudo apt-get install -y hostapd
sudo cp hostapd.conf /etc/hostapd/hostapd.conf
```

## Good
```sh
sudo apt-get install -y hostapd
sudo cp hostapd.conf /etc/hostapd/hostapd.conf
sudo systemctl unmask hostapd
sudo systemctl enable --now hostapd
```

## When to ignore it
When another program, such as create_ap, starts hostapd itself.

## References
- https://www.raspberrypi.com/documentation/computers/configuration.html
- systemctl(1), "mask"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

INSTALLERS = ("apt", "apt-get", "aptitude")
SETS_UP = regex(r"/etc/hostapd/\S{0,80}\.conf|systemctl[^\n]{0,60}\b(?:enable|start|restart)\b[^\n]{0,60}\bhostapd\b")
UNMASKS = regex(r"^[^#\n]*\bunmask\b[^\n]*\bhostapd\b|\bcreate_ap\b|\bmasked:[ \t]*(?:no|false)\b", re.M)
PUT_AWAY = regex(r"^[ \t]*#[^\n]*\bunmask\b[^\n]*\bhostapd\b", re.M, hints="unmask")
"""Somebody took the line out, and so the access point."""


@rule("warning", symptoms=["Unit file /etc/systemd/system/hostapd.service is masked", "hostapd.service is masked"])
def hostapd_masked(robot: Robot) -> Iterator[Finding]:
    for source, run in robot.scripts.run(*INSTALLERS):
        word = _installed(run)
        if word is not None and SETS_UP.search(source.text) and not robot.mentions(UNMASKS):
            yield finding(
                word,
                "The package masks hostapd.service when it is installed: the access point never starts",
                advice="run systemctl unmask hostapd and systemctl enable hostapd afterwards",
                severity="info" if source.matches(PUT_AWAY) else None,
            )


def _installed(run: Run) -> Located | None:
    if "install" not in run.words:
        return None
    return next((word for word in run.words if word == "hostapd"), None)
