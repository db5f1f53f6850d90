"""A program is given a verb that it does not have.

## What it finds
The verb of `ros2`, `colcon`, `rosdep`, `systemctl`, `udevadm`, `apt-get`, `git`, `docker`, `docker compose`, `pip`,
`nmcli`, `ip` and others that is none of theirs, and that differs in one letter from one: one too many, too few or
wrong, or two neighbours exchanged. It is looked for in shell scripts, in `RUN` of a Dockerfile, in `shell` and
`command` of Ansible, in the command lines of units and containers, and within them in `$(...)` and behind `bash -c`.
Other words are not reported: an extension or an alias may bring them.

## Why it matters on a robot
The program ends at once with an error and does nothing: the workspace is not built, the rules of udev are not read
again, the launch file does not start.

## Bad
```sh
sudo udevadm contrl --reload-rules
ros2 lauch rover drive.launch.py
```

## Good
```sh
sudo udevadm control --reload-rules
ros2 launch rover drive.launch.py
```

## When to ignore it
When an extension of the program that is not in the tree brings the verb.

## References
- The help of the programs, such as `ros2 --help` and `colcon --help`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.host import verbs
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import every_command
from bringup_lint.api.shell import functions
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped
from bringup_lint.api.spelling import is_slip

PLAIN = regex(r"[A-Za-z][\w-]{0,30}")


@rule(
    "error",
    confidence="medium",
    symptoms=["ros2: error: argument Call `ros2 <command> -h`", "Unknown command verb *", "E: Invalid operation *"],
)
def unknown_verb(robot: Robot) -> Iterator[Finding]:
    own = functions(robot.files)
    for command in every_command(robot.runners):
        for program, verb in _verbs(command):
            known = verbs()[program]
            if verb in known.slips.known or program in own or _is_start(verb, program):
                continue
            meant = [each for each in known.slips.meant(verb) if is_slip(verb, each)]
            if meant:
                yield finding(
                    verb,
                    f"{program} has no verb '{verb}': it ends with an error and does nothing",
                    advice=f"write {' or '.join(meant)}",
                )


def _verbs(command: Command) -> Iterator[tuple[str, Located]]:
    """The verbs of a command, each with the words before it that take one."""
    words = unwrapped(command.words)
    program = program_name(words[0]) if words else ""
    at = 1
    while program in verbs():
        at = _after_options(words, at, verbs()[program].valued)
        if at >= len(words) or not PLAIN.fullmatch(words[at]) or words[at].span.text != words[at]:
            return
        yield program, words[at]
        program, at = f"{program} {words[at]}", at + 1


def _after_options(words: tuple[Located, ...], at: int, valued: frozenset[str]) -> int:
    while at < len(words) and words[at].startswith("-"):
        at += 2 if words[at] in valued else 1
    return at


def _is_start(verb: str, program: str) -> bool:
    known = verbs()[program]
    return known.abbreviates and any(each.startswith(verb) for each in known.slips.known)
