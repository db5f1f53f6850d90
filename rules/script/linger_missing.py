"""A script enables a user unit that starts only when somebody logs in.

## What it finds
`systemctl --user enable` of a unit of the tree for `default.target`, where no file of the tree has to do with lingering
or with what logs somebody in by itself.

## Why it matters on a robot
The user manager starts at the first login and stops after the last logout. On the bench, somebody is always
logged in. In the field nobody is, and the unit does not run.

## Bad
```sh
systemctl --user enable rover-video
```

## Good
```sh
systemctl --user enable rover-video
sudo loginctl enable-linger rover
```

## When to ignore it
When the unit is only for people who log in, or something that the tree does not hold lets the user linger.

## References
- loginctl(1), "enable-linger"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit

LOGS_IN = regex(
    r"linger|auto-?(?:matic-?)?login|do_boot_behaviour|initial_session|\b(?:nodm|gdm3?|lightdm|sddm|greetd)\b|PAMName=|\buser@",
    re.I,
    hints="linger login do_boot_behaviour initial_session nodm gdm lightdm sddm greetd pamname= user@",
)


@rule("warning", confidence="medium", silent="nothing runs that could say so until somebody logs in")
def linger_missing(robot: Robot) -> Iterator[Finding]:
    if robot.mentions(LOGS_IN):
        return
    for _, run in robot.scripts.run("systemctl"):
        if "--user" not in run.words or "enable" not in run.words:
            continue
        for word in run.words[1:]:
            unit = _at_login(robot, str(word))
            if unit is not None:
                yield finding(
                    word,
                    f"{unit.name} starts only when its user logs in, and stops after the last logout",
                    advice="run loginctl enable-linger USER, or use a system unit with User=",
                    related=[note(unit.where, "the unit")],
                )


def _at_login(robot: Robot, word: str) -> Unit | None:
    """The unit of the tree with this name, where the first login starts it."""
    named = (unit for unit in robot.units.services if word in (unit.name, unit.stem) and unit.fragment is not None)
    return next((unit for unit in named if "default.target" in unit.words("WantedBy", "Install")), None)
