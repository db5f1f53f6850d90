"""setpriv without the user's groups.

## What it finds
A command that changes the user with `setpriv --reuid`, and has neither `--init-groups` nor `--groups`.

## Why it matters on a robot
The process runs as the right user but without `dialout`, `video` or `input`. It cannot open serial ports,
cameras and joysticks, although the same command works in a shell of that user.

## Bad
```ini
[Service]
ExecStart=/usr/bin/setpriv --reuid rover --regid rover --clear-groups /opt/rover/bin/base
```

## Good
```ini
[Service]
User=rover
ExecStart=/opt/rover/bin/base
```

## When to ignore it
When the process opens no device and needs no group besides its primary one.

## References
- setpriv(1)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["Permission denied: '/dev/tty"])
def setpriv_without_groups(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("setpriv"):
        for process in robot.units.processes(unit):
            for step in process.steps:
                words = step.command.words
                if "setpriv" not in [word.rpartition("/")[2] for word in words[:2]]:
                    continue
                options = [word for word in words if word.startswith("--")]
                user = [word for word in options if word.partition("=")[0] == "--reuid"]
                if not user or any(word.partition("=")[0] in ("--init-groups", "--groups") for word in options):
                    continue
                yield finding(
                    user[0],
                    "The process gets the user but not the user's groups: it cannot open devices of dialout, video "
                    "or input",
                    advice="use User= in the unit, or add --init-groups",
                    related=[note(process.program, f"{unit.name} starts it here")] if step.script else (),
                )
