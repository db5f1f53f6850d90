"""A console logs in a user without a password.

## What it finds
`agetty --autologin` (or `-a`) in a drop-in of `getty@`, `serial-getty@` or `console-getty`, or in any other
service. It is a warning for root and on a serial line, and an info for another user on the screen.

## Why it matters on a robot
Robots work where the public can reach them. Anyone who plugs in a keyboard or a serial adapter gets a shell
without a password. As root, this shell controls the whole robot: keys, firmware, motors.

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

## When to ignore it
On a kiosk or a development robot where the console is locked away, and the user has no rights beyond the
display.

## References
- agetty(8), "--autologin"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process

SERIAL = regex(r"(?:/dev/)?tty(?:S|AMA|THS|USB|ACM|GS|mxc|PS)\d")


@rule("warning", tags=["CWE-287"], symptoms=["automatic login"])
def console_autologin(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("getty"):
        for process in robot.units.started(unit):
            user = autologin(process)
            if user is None or not user.span.source.judged:
                continue
            serial = unit.name.startswith("serial-getty@") or any(map(SERIAL.match, process.argv))
            yield finding(
                user,
                f"Anyone with access to {'the serial line' if serial else 'the console'} is {user} without a password",
                advice="remove --autologin, and start the robot's software from a unit",
                severity=None if user == "root" or serial else "info",
            )


def autologin(process: Process) -> Located | None:
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
