"""A set-up script ends in an error when it is run again.

## What it finds
In a script under `set -e`, outside of branches and loops, a command that fails when what it makes is there already:
`rosdep init`, `groupadd` and `useradd`, `mkdir` without `-p` and `ln -s` without `-f` for a path that is known.

An info for users and groups. Silent where the script removes the path before or asks for it, in scripts that build an
image, and for temporary folders.

## Why it matters on a robot
Set-up scripts are run again: after a step that failed, after an update, for the next user. The second run ends at this
command, and everything after it is never done: no packages, no build, no service.

## Bad
```sh
set -e
sudo rosdep init
rosdep update
```

## Good
```sh
set -e
[ -e /etc/ros/rosdep/sources.list.d/20-default.list ] || sudo rosdep init
rosdep update
```

## When to ignore it
When the script is only for a robot on which nothing is installed yet, and is never run twice.

## References
- https://github.com/ros-infrastructure/rosdep: "ERROR: default sources list file already exists"
- bash(1), "SHELL BUILTIN COMMANDS", set -e
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import ended_by_failure
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import runs_in_image
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import unwrapped

HAS_COMMAND = regex(r"\brosdep[ \t]+init\b|\b(?:groupadd|useradd|mkdir|ln)[ \t]")
KNOWN = regex(r"(?:/|~/|\$HOME/|\$\{HOME\}/)(?!tmp/|run/|dev/shm/|proc/|sys/)[\w./@+-]+")
ASKS = r"(?:\[|\b(?:test|rm|getent|id|grep|unlink|userdel|groupdel|ls)\b)"
FILE = regex(r"\.\w+\Z|/s?bin/[^/]+\Z")
"""What is no folder; a link to a folder gets the next link inside."""
ADVICE = {
    "rosdep": "write [ -e /etc/ros/rosdep/sources.list.d/20-default.list ] || before it",
    "groupadd": "write groupadd -f",
    "useradd": "write id NAME || before it",
    "mkdir": "write mkdir -p",
    "ln": "write ln -sfn",
}


@rule("warning", symptoms=["ERROR: default sources list file already exists"])
def second_run_ends(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or not source.matches(HAS_COMMAND):
            continue
        if runs_in_image(source) or robot.scripts.is_for_image(source):
            continue
        statements = shell_blocks(source)
        always = {id(statements), *(id(block.bodies[0]) for block in statements if block.kind == "function")}
        for statement in ended_by_failure(source):
            command = statement.block.command if id(statement.among) in always else None
            found = _made(command) if command is not None and statement.after not in ("&&", "||", "|") else None
            if found is not None and not _is_asked_for(source, found[1]):
                program, made = found
                yield finding(
                    made,
                    f"This fails when it is there already: under set -e the second run of {source.basename} ends here",
                    advice=ADVICE[program],
                    severity="info" if program in ("groupadd", "useradd") else None,
                )


def _made(command: Command) -> tuple[str, Located] | None:
    """The program of a command that fails where something is there already, and what this is."""
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    options = [word for word in words[1:] if word.startswith("-")]
    plain = [word for word in words[1:] if not word.startswith("-")]
    letters = "".join(options)
    if name == "rosdep":
        return (name, words[0]) if plain[:1] == ["init"] else None
    if name in ("groupadd", "useradd"):
        return (name, words[-1]) if "f" not in letters and plain and words[-1].isidentifier() else None
    if name == "mkdir":
        return (name, plain[-1]) if "p" not in letters and len(plain) == 1 and KNOWN.fullmatch(plain[0]) else None
    if name == "ln" and "s" in letters and "f" not in letters and len(plain) == 2 and FILE.search(plain[0]):
        return (name, plain[1]) if KNOWN.fullmatch(plain[1]) and not plain[1].endswith("/") else None
    return None


def _is_asked_for(source: Source, made: Located) -> bool:
    """Whether the script looks for what it makes, or removes it."""
    name = "20-default" if made == "rosdep" else made.rpartition("/")[2]
    return re.search(rf"{ASKS}[^\n]*{re.escape(name)}", source.text) is not None
