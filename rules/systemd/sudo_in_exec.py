"""sudo inside a service.

## What it finds
`sudo` in a command line of a unit, in its `-c` text, or in a script of the tree that it starts. With
`NoNewPrivileges=yes` this is an error: sudo cannot work there.

## Why it matters on a robot
A service has no terminal on which sudo could ask for a password: it either fails, or the robot's user was
given `NOPASSWD`, which hands root to everything else that this user runs. systemd can give one command more
rights, or run the whole unit as another user, without that.

## Bad
```ini
[Service]
User=rover
ExecStartPre=/usr/bin/sudo /usr/sbin/ip link set can0 up
```

## Good
```ini
[Service]
User=rover
ExecStartPre=+/usr/sbin/ip link set can0 up
```

## References
- systemd.service(5), "Command lines": the prefix `+`
- systemd.exec(5), "NoNewPrivileges="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    tags=["CWE-250"],
    symptoms=["sudo: a terminal is required to read the password", "sudo: effective uid is not 0"],
)
def sudo_in_exec(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        locked = unit.get("NoNewPrivileges")
        locked = locked if locked and locked.lower() in ("yes", "true", "on", "1", "y", "t") else None
        for process in robot.units.processes(unit):
            for step in process.steps:
                words = [word for word in step.command.words[:2] if word.rpartition("/")[2] == "sudo"]
                if not words or step.command.words[0] not in (words[0], "exec") or (step.script and not locked):
                    continue
                related = [note(locked, "forbids what sudo does")] if locked else []
                if step.script:
                    related.append(note(process.program, f"{unit.name} starts the script here"))
                yield finding(
                    words[0],
                    "sudo cannot work here: NoNewPrivileges= takes away its set-user-ID bit"
                    if locked
                    else ("sudo in a service has no terminal to ask for a password, and NOPASSWD gives root away"),
                    advice="let systemd do it: '+' before this one command, or User= for the unit",
                    related=related,
                    severity="error" if locked else None,
                )
