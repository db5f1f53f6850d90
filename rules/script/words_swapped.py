"""The words of a command are in the wrong order.

## What it finds
In scripts, images and the commands of containers:

- `ssh service restart` and `service restart ssh`, which are meant to be `service ssh restart`;
- `systemctl rover start` for `systemctl start rover`;
- `adduser dialout pi`, `gpasswd -a dialout pi` and `usermod -aG pi dialout`: the user and the group are exchanged. Only
  with groups of the distribution, such as `dialout`, `video` and `docker`.

## Why it matters on a robot
The command ends with an error that scrolls past: sshd does not run, the service is not started, or the account has no
access to the serial port. `ssh service restart` even tries to log in on a computer called "service".

## Bad
```sh
service restart ssh
adduser dialout rover
```

## Good
```sh
service ssh restart
adduser rover dialout
```

## When to ignore it
When a host, a unit or an account really has this name.

## References
- service(8), systemctl(1), adduser(8), gpasswd(1), usermod(8)
"""

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import commands_of
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

PROGRAMS = ("ssh", "service", "systemctl", "adduser", "gpasswd", "usermod")
VERBS = ("start", "stop", "restart", "reload", "status")
UNIT_VERBS = (*VERBS, "enable", "disable", "mask", "unmask")
GROUPS = frozenset("audio bluetooth dialout docker gpio i2c input netdev plugdev render spi tty video".split())
ADDS = regex(r"-[a-zA-Z]{0,3}[aG][a-zA-Z]{0,3}|--append|--groups")
NAME = regex(r"\$?\{?[\w@][\w@.-]*\}?")
UNIT = regex(r"[\w@][\w@.-]*")
"""Not a variable, which may hold the verb."""


@rule("warning", symptoms=["ssh: Could not resolve hostname service", "unrecognized service", "Unknown command verb"])
def words_swapped(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for command in _commands(robot):
        meant = _meant(command)
        if meant and command[0].span not in seen:
            seen.add(command[0].span)
            yield finding(
                command[0],
                f"The words are in the wrong order: '{' '.join(command)}' does nothing but fail",
                advice=f"write {meant}",
            )


def _commands(robot: Robot) -> Iterator[Sequence[Located]]:
    """The commands of scripts, steps of images, and what containers start."""
    for _, run in robot.scripts.run(*PROGRAMS):
        yield run.words
    for file in robot.dockerfiles:
        for stage in file.stages:
            yield from (unwrapped(command.words) for command in commands_of(stage))
    for runner in robot.runners.all:
        if runner.in_container:
            yield from (unwrapped(step.command.words) for line in runner.lines for step in line.steps)


def _meant(words: Sequence[Located]) -> str:
    """What a command is meant to be; empty where its words are in their order."""
    program = program_name(words[0]) if words else ""
    first, second, *rest = (*map(str, words[1:]), "", "")
    if program not in PROGRAMS or any(rest[:-2]):
        return _meant_of_three(program, words)
    if program == "ssh" and first in ("service", "systemctl") and second in VERBS:
        return f"service ssh {second}"
    if program == "service" and first in VERBS and NAME.fullmatch(second) and second not in VERBS:
        return f"service {second} {first}"
    if program == "systemctl" and first not in UNIT_VERBS and second in UNIT_VERBS and UNIT.fullmatch(first):
        return f"systemctl {second} {first}"
    if program == "adduser" and first in GROUPS and second not in GROUPS and NAME.fullmatch(second):
        return f"adduser {second} {first}"
    return ""


def _meant_of_three(program: str, words: Sequence[Located]) -> str:
    """The same for ``gpasswd -a USER GROUP`` and ``usermod -aG GROUP USER``."""
    if len(words) != 4 or not ADDS.fullmatch(words[1]):
        return ""
    first, second = str(words[2]), str(words[3])
    group, user = (first, second) if program == "gpasswd" else (second, first)
    if program in ("gpasswd", "usermod") and group in GROUPS and user not in GROUPS and NAME.fullmatch(user):
        order = f"{user} {group}" if program == "gpasswd" else f"{group} {user}"
        return f"{program} {words[1]} {order}"
    return ""
