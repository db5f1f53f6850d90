"""sudo in a service.

## What it finds
`sudo` in a command line of a unit or in its `-c` text. With `NoNewPrivileges=yes` it is an error, and scripts
of the tree that the unit starts are checked too.

## Why it matters on a robot
A service has no terminal on which sudo could ask for a password. sudo fails, unless the robot's user has
`NOPASSWD`, which gives root to everything else that this user runs. Without that, systemd can run one command
with more rights, or the whole unit as another user.

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

## When to ignore it
When sudoers allows exactly this command without a password, and a system unit cannot run it.

## References
- systemd.service(5), "Command lines": the prefix `+`
- systemd.exec(5), "NoNewPrivileges="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Step
from bringup_lint.api.systemd import Unit


@rule(
    "warning",
    tags=["CWE-250"],
    symptoms=[
        "sudo: a terminal is required to read the password",
        "sudo: effective uid is not 0",
        "sudo: no tty present and no askpass program specified",
    ],
)
def sudo_in_exec(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("sudo"):
        privileges = unit.flag("NoNewPrivileges")
        locked = privileges.at if privileges else None
        found = [
            (process, step, word)
            for process in robot.units.processes(unit)
            for step in process.steps
            if (word := _sudo(step)) is not None and (locked or not (step.script or _lowers(unit, step)))
        ]
        if found:
            yield _finding(unit, locked, found)


def _lowers(unit: Unit, step: Step) -> bool:
    """Whether root runs the command as another user, for which sudo asks nothing."""
    words = step.command.words
    return unit.get("User") in (None, "root", "0") and any(word.startswith(("-u", "--user")) for word in words[1:3])


def _sudo(step: Step) -> Located | None:
    """The word ``sudo`` where it is the program of a command."""
    words = [word for word in step.command.words[:2] if word.rpartition("/")[2] == "sudo"]
    return words[0] if words and step.command.words[0] in (words[0], "exec") else None


def _finding(unit: Unit, locked: Located | None, found: list[tuple[Process, Step, Located]]) -> Finding:
    (process, step, word), *others = found
    related = [note(locked, "prevents sudo from gaining privileges")] if locked else []
    if step.script:
        related.append(note(process.program, f"{unit.name} starts the script here"))
    return finding(
        word,
        "sudo cannot work here: NoNewPrivileges= disables its set-user-ID bit"
        if locked
        else "sudo in a service has no terminal to ask for a password, and NOPASSWD gives root away",
        advice="let systemd do it: prefix this one command with '+', or set User= for the unit",
        related=[*related, *(note(other, "sudo here too") for _, _, other in others)],
        severity="error" if locked else None,
    )
