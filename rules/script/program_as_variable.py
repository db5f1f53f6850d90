"""The name of a program stands in the place of a variable.

## What it finds
`${nproc}`, `$nproc`, `${pwd}`, `${whoami}` and other names of programs in scripts and in the steps of images, where
nothing in the file sets such a variable. `$(nproc)` is meant. Silent in scripts that read other files of the robot,
which may set it.

## Why it matters on a robot
The variable is empty. `make -j${nproc}` becomes `make -j`, which starts a compiler for every file at once: a Jetson or
a Raspberry Pi runs out of memory and kills the compiler, or no longer answers. `${pwd}/maps` becomes `/maps`.

## Bad
```dockerfile
RUN cmake .. && make -j${nproc} && make install
```

## Good
```dockerfile
RUN cmake .. && make -j$(nproc) && make install
```

## When to ignore it
When whoever starts the script sets a variable of this name.

## References
- bash(1), "Command Substitution" and "Parameter Expansion"
- make(1), `-j`
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import commands_of
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import Word
from bringup_lint.api.shell import shell_commands

PROGRAMS = "nproc|pwd|whoami|uname|dirname|basename|realpath|readlink|mktemp|rospack|lsb_release"
USE = regex(rf"(?<!\\)\$(?:\{{(?P<braced>{PROGRAMS})\}}|(?P<plain>{PROGRAMS})(?!\w))", hints="$")
SET = regex(rf"(?<![$\w{{(-])(?:{PROGRAMS})(?:\+?=|[ \t]+in\b)|^[ \t]*(?:ARG|ENV)[ \t]+(?:{PROGRAMS})\b", re.I | re.M)
READS = ("source", ".", "eval", "read", "mapfile", "getopts")
OF_ROS = regex(r"(?:^|/)(?:local_)?setup\.(?:ba|z)?sh\Z|/opt/ros/", hints="setup. /opt/ros/")
JOBS = ("-j", "-j ", "--jobs=", "--jobs ")
MOST = 20


@rule("warning", symptoms=["fatal error: Killed signal terminated program cc1plus"])
def program_as_variable(robot: Robot) -> Iterator[Finding]:
    for source, commands in _files(robot):
        if SET.search(source.said) or any(map(_may_set, commands)):
            continue
        uses = [use for command in commands for use in _uses(command)]
        if uses:
            yield _report(uses)


def _files(robot: Robot) -> Iterator[tuple[Source, list[Command]]]:
    """The scripts and Dockerfiles that have such a variable, with their commands."""
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and USE.search(source.said):
            yield source, shell_commands(source)
    for file in robot.dockerfiles:
        if USE.search(file.source.said):
            yield file.source, [command for stage in file.stages for command in commands_of(stage)]


def _may_set(command: Command) -> bool:
    """Whether a command may set variables whose names the file does not say."""
    if command.name not in READS:
        return False
    return not (len(command.words) > 1 and OF_ROS.search(command.words[1]))


def _uses(command: Command) -> Iterator[Located]:
    """The variables in a command, without those that the shell does not replace."""
    for word in (*command.assignments, *command.words):
        for part, quote in word.stretches() if isinstance(word, Word) else ((word, ""),):
            if quote != "'":
                yield from (part.part(*match.span()) for match in USE.finditer(part))


def _report(uses: list[Located]) -> Finding:
    first, *others = sorted(uses, key=_is_number_of_jobs, reverse=True)
    name = first.strip("${}")
    what = f"nothing sets the variable {name}, which is the name of a program"
    unlimited = f"make gets -j without a number and starts as many compilers at once as there are files: {what}"
    return finding(
        first,
        unlimited if _is_number_of_jobs(first) else f"{first} is empty: {what}",
        advice=f"write $({name})",
        related=[note(other, "the same") for other in others[:MOST]],
    )


def _is_number_of_jobs(use: Located) -> bool:
    """Whether a variable is the number of processes of make."""
    before = use.span.source.line_before(use.span.start)
    return "make " in before and before.endswith(JOBS)
