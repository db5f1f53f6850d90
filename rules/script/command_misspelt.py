"""The name of a well-known command is misspelt.

## What it finds
The first word of a command that is no command, and that differs in one letter from a well-known one, or from a function
of the tree: one letter too many, too few or wrong, or two neighbours exchanged, as in `sudp`, `mkidr` or `rodep`. It is
looked for in shell scripts, in `RUN` of a Dockerfile, in `shell` and `command` of Ansible, in the command lines of
units and containers, and within them in `$(...)` and behind `bash -c`. Silent where the tree defines a function, an
alias, a program or a file of that name, or installs something of that name.

## Why it matters on a robot
The shell says "command not found" and goes on with the next line: the package is not installed, the file is not
sourced, and the robot starts without it.

## Bad
```sh
sudp apt-get install -y can-utils
```

## Good
```sh
sudo apt-get install -y can-utils
```

## When to ignore it
When a program of this name is on the robot.

## References
- bash(1), "Command Execution"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.host import is_program
from bringup_lint.api.host import meant_programs
from bringup_lint.api.shell import every_command
from bringup_lint.api.shell import functions
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped
from bringup_lint.api.spelling import Neighbours
from bringup_lint.api.spelling import is_slip

NAME = regex(r"(?:/(?:usr/)?s?bin/)?(?P<name>[A-Za-z][\w.+-]{2,30})")


@rule("error", confidence="medium", symptoms=["command not found"])
def command_misspelt(robot: Robot) -> Iterator[Finding]:
    own = functions(robot.files)
    slips = Neighbours(each for each in own if len(each) > 5)
    for word in _names(robot):
        name = program_name(word)
        if name not in own:
            meant = meant_programs(name) or _functions(slips, name)
            if meant and not _is_defined(robot, name):
                yield finding(
                    word,
                    f"There is no command '{name}': the shell does not run this",
                    advice=f"write {' or '.join(meant)}",
                )


def _functions(slips: Neighbours, name: str) -> list[str]:
    """The functions of the tree of which one is meant."""
    return [] if is_program(name) else [each for each in slips.meant(name) if is_slip(name, each)]


def _names(robot: Robot) -> Iterator[Located]:
    for command in every_command(robot.runners):
        for word in dict.fromkeys((*command.words[:1], *unwrapped(command.words)[:1])):
            if NAME.fullmatch(word) and word.span.text == word:
                yield word


def _is_defined(robot: Robot, name: str) -> bool:
    """Whether something of the tree may bring a command of the name."""
    written = re.escape(name)
    installs = rf"(?:local/bin/|\binstall[ \t][^\n]*[ \t]){written}(?![\w.-])"
    defines = re.compile(rf"{installs}|[\"']{written}[ \t]*=")
    return any(robot.tree.named(name)) or robot.files.mentions(defines)
