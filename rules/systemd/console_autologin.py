"""A console that logs in by itself.

## What it finds
`agetty --autologin` (or `-a`) in a drop-in of `getty@`, `serial-getty@` or `console-getty`, or in a unit of one's own:
a warning for root and on a serial line, for information for another user on the screen.

## Why it matters on a robot
Robots stand where people pass by. Whoever plugs in a keyboard or a serial adapter has a shell without a password, and
as root the whole robot: keys, firmware, motors.

## Bad
```ini
[Service]
ExecStart=
ExecStart=-/sbin/agetty --autologin root --keep-baud 115200 %I $TERM
```

## Good
```ini
[Service]
ExecStart=
ExecStart=-/sbin/agetty --keep-baud 115200 %I $TERM
```

## References
- agetty(8), "--autologin"
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

SERIAL = re.compile(r"(?:/dev/)?tty(?:S|AMA|THS|USB|ACM|GS|mxc|PS)\d")


@rule("warning", tags=["CWE-287"], symptoms=["automatic login"])
def console_autologin(robot: Robot):
    for unit in robot.units.services:
        for process in robot.units.started(unit):
            user = autologin(process)
            if user is None or not user.span.source.judged:
                continue
            serial = unit.name.startswith("serial-getty@") or any(
                "tty" in word and "S" in word for word in process.argv
            )
            yield finding(
                user,
                f"Whoever reaches {'the serial line' if serial else 'the console'} is {user} without a password",
                advice="leave --autologin out, and start the robot's software from a unit",
                severity=None if user == "root" or serial else "info",
            )


def autologin(process):
    """The user that agetty logs in."""
    if process.program.rpartition("/")[2] not in ("agetty", "getty"):
        return None
    words = process.argv[1:]
    for word, following in zip(words, [*words[1:], None]):
        if word in ("--autologin", "-a"):
            return following
        if word.startswith("--autologin="):
            return word.part(len("--autologin="), len(word))
    return None
